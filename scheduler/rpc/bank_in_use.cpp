#include "scheduler/rpc/bank_in_use.h"

#include <algorithm>

#include "digest/sha256.h"
#include "input/field.h"
#include "scheduler/gap/kernels.h"

namespace regolab {
namespace {

std::set<std::uint64_t> seeds_of(const gap::Bank& bank) {
  std::set<std::uint64_t> seeds;
  for (const gap::BankRow& row : bank.rows) seeds.insert(row.seed);
  return seeds;
}

std::map<std::string, double> constants_of(const gap::Bank& bank) {
  std::map<std::string, double> constants;
  for (std::size_t k = 0; k < bank.inputs.size() && !bank.rows.empty(); ++k) {
    const Field* field = find_field(bank.inputs[k].name);
    if (!field || (field->group != Field::Group::kMicro && field->group != Field::Group::kMaterial)) continue;
    const double first = bank.rows.front().inputs[k];
    if (std::ranges::all_of(bank.rows, [&](const gap::BankRow& row) { return row.inputs[k] == first; })) constants[bank.inputs[k].name] = first;
  }
  return constants;
}

Result<BankInUse> shipped() {
  const auto& own = gap::shipped_emulator();
  if (!own.ok()) return own.error();
  BankInUse out{.emulator = std::shared_ptr<const gap::Emulator>(std::shared_ptr<const void>(), &*own), .diagnostics = {}, .seeds = {}, .constants = {}};
  const std::string bank(gap::shipped_bank());
  out.bank = sha256_hex(bank), out.kernels = sha256_hex(gap::shipped_kernels());
  if (const auto read = gap::read_bank("bank.csv", bank); read.value) out.seeds = seeds_of(*read.value), out.constants = constants_of(*read.value);
  return out;
}

Result<BankInUse> read(const v1::DiagnoseRequest& request) {
  BankInUse out{.emulator = {}, .diagnostics = {}, .bank = sha256_hex(request.bank_csv()), .kernels = sha256_hex(request.kernels_json()), .seeds = {}, .constants = {}};
  auto bank = gap::read_bank(request.bank_name(), request.bank_csv());
  out.diagnostics = std::move(bank.diagnostics);
  if (!bank.value) return out;
  out.seeds = seeds_of(*bank.value), out.constants = constants_of(*bank.value);
  std::vector<gap::Kernel> kernels;
  if (!request.kernels_json().empty()) {
    auto from_file = gap::kernels_from_json(request.kernels_json());
    if (!from_file.ok()) return from_file.error();
    kernels = std::move(*from_file);
  }
  auto emulator = gap::Emulator::from(*bank.value, kernels);
  if (!emulator.ok()) return emulator.error();
  out.emulator = std::make_shared<const gap::Emulator>(std::move(*emulator));
  return out;
}

}  // namespace

Result<BankInUse> Banks::of(const v1::DiagnoseRequest& request) {
  if (request.bank_csv().empty()) {
    static const Result<BankInUse> own = shipped();
    return own;
  }
  {
    const std::lock_guard lock(mutex_);
    if (last_.emulator && last_.bank == sha256_hex(request.bank_csv()) && last_.kernels == sha256_hex(request.kernels_json())) return last_;
  }
  auto fresh = read(request);
  if (!fresh.ok() || !fresh->emulator) return fresh;
  const std::lock_guard lock(mutex_);
  last_ = *fresh;
  return fresh;
}

}  // namespace regolab
