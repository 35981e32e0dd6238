/// The bank that a caller hands in as text, or the program's own where it hands in none.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "input/diagnostic.h"
#include "scheduler/gap/emulator.h"

namespace regolab::gap {

struct BankInUse {
  std::optional<Result<Emulator>> own;
  std::vector<Diagnostic> diagnostics;  ///< not empty: the text is no bank, and the emulator must not be asked for

  const Result<Emulator>& emulator() const;
};

/// kernels_json: of that bank; empty: fitted anew, which takes minutes. An empty csv is the program's own bank.
BankInUse bank_in_use(const std::string& name, const std::string& csv, const std::string& kernels_json);

}  // namespace regolab::gap
