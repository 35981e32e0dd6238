/// What the verbs of `gap` share.
#pragma once
#include "client/arguments.h"
#include "client/outcome.h"
#include "client/wire.h"

namespace regolab::client {

/// The measurements that the arguments name, as the scheduler takes them. Errors: a file that cannot be read or is too large.
Outcome read_measurements(const Arguments& arguments, pb::ImportRequest& request);

inline constexpr std::size_t kLargestBank = 16 << 20;  ///< [bytes]

/// The files of another bank than the program's own, as a diagnosis takes them.
Outcome read_bank_files(const Arguments& arguments, pb::DiagnoseRequest& request);

}  // namespace regolab::client
