/// What a diagnosis says about the next test.
#pragma once
#include <string>

#include "client/json_view.h"
#include "client/wire.h"

namespace regolab::client {

/// "next    stress test at 2.5 kPa (0.41 nat in 9 h) would tell cohesion from loading_rate"
std::string next_line(const pb::Diagnosis& diagnosis);

/// A table of all tests.
std::string next_text(const pb::Diagnosis& diagnosis);

/// [{test, eig_nats, eig_error, hours, splits}]; eig_nats is null where no emulator foretells the test.
Json next_json(const pb::Diagnosis& diagnosis);

}  // namespace regolab::client
