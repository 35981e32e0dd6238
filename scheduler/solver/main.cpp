/// regolab-solver: one blind case from stdin, its answer to stdout. See README.md.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "digest/sha256.h"
#include "input/unit_convert.h"
#include "scheduler/gap/bank_in_use.h"
#include "scheduler/gap/blind/answer.h"
#include "scheduler/gap/kernels.h"
#include "scheduler/gap/observation_file.h"
#include "scheduler/solver/confinement.h"

namespace regolab {
namespace {

constexpr int kDone = 0, kUsage = 2, kNoBank = 3;

/// Empty of no file.
std::string text_of(const std::string& file) {
  if (file.empty()) return {};
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Every way that a case can be answered; one that cannot be read is CANNOT TELL, with its reason.
gap::Answer answer_to(const std::string& measurements, const gap::Emulator& emulator, std::uint64_t seed) {
  gap::Answer out;
  const auto set = gap::read_observations("observations", measurements, gap::MissingErrors::kAssume);
  if (!set.ok()) {
    out.problem = to_text(set.diagnostics.front());
    return out;
  }
  out.case_name = set.value->name;
  gap::DiagnosisOptions options;
  options.smc.seed = seed;
  auto found = gap::diagnose(emulator, *set.value, options);
  if (!found.ok()) {
    out.problem = found.error().text;
    return out;
  }
  out.diagnosis = std::move(*found);
  out.baselines = gap::baselines_of(emulator, *set.value, seed);
  return out;
}

int run(const std::string& bank_file, const std::string& kernels_file, std::uint64_t seed) {
  const std::string csv = text_of(bank_file);
  const gap::BankInUse bank = gap::bank_in_use(bank_file, csv, text_of(kernels_file));
  if (!bank.diagnostics.empty() || !bank.emulator().ok()) {
    std::cerr << "regolab-solver: " << (bank.diagnostics.empty() ? bank.emulator().error().text : to_text(bank.diagnostics.front())) << "\n";
    return kNoBank;
  }
  if (!convert_to_si(1, "1", "kPa", "Pa", "sigma3").ok()) {  // the table of units is a file: read it while files can be read
    std::cerr << "regolab-solver: no table of units (udunits2 is not installed) install it\n";
    return kNoBank;
  }
  const std::string protection = confine({});
  const std::string measurements(std::istreambuf_iterator<char>(std::cin), {});
  gap::Answer answer = answer_to(measurements, *bank.emulator(), seed);
  answer.source = {.bank = sha256_hex(csv.empty() ? std::string(gap::shipped_bank()) : csv).substr(0, 12),
                   .measurements = sha256_hex(measurements),
                   .program = REGOLAB_VERSION,
                   .seed = seed,
                   .protection = protection};
  std::cout << gap::answer_text(answer) << std::flush;
  return std::cout ? kDone : 1;
}

}  // namespace
}  // namespace regolab

int main(int argc, char** argv) {
  CLI::App app("answers one blind case: observations on stdin, the answer as JSON on stdout", "regolab-solver");
  std::string bank, kernels;
  std::uint64_t seed = 1;
  app.add_option("--bank", bank, "another bank than the program's own")->check(CLI::ExistingFile);
  app.add_option("--kernels", kernels, "of that bank")->check(CLI::ExistingFile);
  app.add_option("--seed", seed, "of the sampler [1]");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? regolab::kDone : regolab::kUsage;
  }
  return regolab::run(bank, kernels, seed);
}
