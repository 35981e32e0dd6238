#include "scheduler/gap/bank_in_use.h"

#include "scheduler/gap/kernels.h"

namespace regolab::gap {

const Result<Emulator>& BankInUse::emulator() const { return own ? *own : shipped_emulator(); }

BankInUse bank_in_use(const std::string& name, const std::string& csv, const std::string& kernels_json) {
  BankInUse out;
  if (csv.empty()) return out;
  auto bank = read_bank(name, csv);
  out.diagnostics = std::move(bank.diagnostics);
  if (!bank.value) return out;
  std::vector<Kernel> kernels;
  if (!kernels_json.empty()) {
    auto read = kernels_from_json(kernels_json);
    if (!read.ok()) {
      out.own = read.error();
      return out;
    }
    kernels = std::move(*read);
  }
  out.own = Emulator::from(*bank.value, kernels);
  return out;
}

}  // namespace regolab::gap
