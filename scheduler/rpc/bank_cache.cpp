#include "scheduler/rpc/bank_cache.h"

#include <algorithm>

#include "digest/sha256.h"
#include "input/field.h"
#include "scheduler/gap/bank_in_use.h"
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

/// What runs a bank has, beside what they measured.
void describe(const gap::Bank& bank, HeldBank& out) { out.seeds = seeds_of(bank), out.constants = constants_of(bank); }

Result<HeldBank> shipped() {
  const auto& own = gap::shipped_emulator();
  if (!own.ok()) return own.error();
  HeldBank out{.emulator = std::shared_ptr<const gap::Emulator>(std::shared_ptr<const void>(), &*own), .diagnostics = {}, .seeds = {}, .constants = {}};  // lives as long as the program
  const std::string bank(gap::shipped_bank());
  out.bank = sha256_hex(bank), out.kernels = sha256_hex(gap::shipped_kernels());
  if (const auto read = gap::read_bank("bank.csv", bank); read.value) describe(*read.value, out);
  return out;
}

Result<HeldBank> read(const v1::DiagnoseRequest& request) {
  HeldBank out{.emulator = {}, .diagnostics = {}, .bank = sha256_hex(request.bank_csv()), .kernels = sha256_hex(request.kernels_json()), .seeds = {}, .constants = {}};
  gap::BankInUse in_use = gap::bank_in_use(request.bank_name(), request.bank_csv(), request.kernels_json());
  out.diagnostics = std::move(in_use.diagnostics);
  if (!out.diagnostics.empty()) return out;
  if (!in_use.emulator().ok()) return in_use.emulator().error();
  out.emulator = std::make_shared<const gap::Emulator>(std::move(**in_use.own));
  if (const auto bank = gap::read_bank(request.bank_name(), request.bank_csv()); bank.value) describe(*bank.value, out);
  return out;
}

}  // namespace

Result<HeldBank> BankCache::of(const v1::DiagnoseRequest& request) {
  if (request.bank_csv().empty()) {
    static const Result<HeldBank> own = shipped();
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
