/// What fitting an emulator found, as a file; and the bank that comes with the program.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/emulator.h"

namespace regolab::gap {

std::string kernels_json(const std::vector<Kernel>& kernels);
/// kDataLoss: not ours, or damaged.
Result<std::vector<Kernel>> kernels_from_json(const std::string& text);

/// As compiled in; empty when this build has none.
std::string_view shipped_bank();
std::string_view shipped_kernels();

/// Of the shipped bank, built once. kFailedPrecondition: this build has none.
const Result<Emulator>& shipped_emulator();

}  // namespace regolab::gap
