/// The bank that a request brings, or the program's own, as an emulator.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "regolab/v1/lab.pb.h"
#include "scheduler/gap/emulator.h"

namespace regolab {

struct HeldBank {
  std::shared_ptr<const gap::Emulator> emulator;
  std::vector<Diagnostic> diagnostics;  ///< not empty: the bank cannot be read
  std::string bank, kernels;            ///< SHA-256 of their texts
  std::set<std::uint64_t> seeds;        ///< of its runs
  std::map<std::string, double> constants;  ///< of the material, the same in every run [SI]
};

/// Keeps the last bank that was not the program's own: a confirmation asks for it again and again. Any thread.
class BankCache {
 public:
  /// kFailedPrecondition: this build has no bank, or too few runs; kDataLoss: damaged kernels.
  Result<HeldBank> of(const v1::DiagnoseRequest& request);

 private:
  std::mutex mutex_;
  HeldBank last_;  ///< guarded by mutex_
};

}  // namespace regolab
