#include "scheduler/gap/kernels.h"

#include <exception>
#include <nlohmann/json.hpp>

namespace regolab::gap {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kFormat = "regolab.gap-kernels/1";

Result<Emulator> build_shipped() {
  const std::string text(shipped_bank());
  if (text.empty()) return Error{Code::kFailedPrecondition, "this build ships no bank (scheduler/gap/data/bank.csv was not there) give --bank FILE"};
  const auto bank = read_bank("bank.csv", text);
  if (!bank.ok()) return Error{Code::kDataLoss, "the shipped bank cannot be read (" + to_text(bank.diagnostics.front()) + ") build again from a clean clone"};
  std::vector<Kernel> kernels;
  if (!shipped_kernels().empty()) {
    auto read = kernels_from_json(std::string(shipped_kernels()));
    if (!read.ok()) return read.error();
    kernels = std::move(*read);
  }
  return Emulator::from(*bank.value, kernels);
}

}  // namespace

std::string kernels_json(const std::vector<Kernel>& kernels) {
  std::string text = std::string("{\"format\": \"") + kFormat + "\", \"kernels\": [";
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    const Kernel& one = kernels[k];
    text += (k ? ",\n" : "\n") + Json{{"group", one.group}, {"log_length", one.log_length}, {"log_trend", one.log_trend}, {"log_noise", one.log_noise}}.dump();
  }
  return text + "]}\n";
}

Result<std::vector<Kernel>> kernels_from_json(const std::string& text) {
  try {
    const Json in = Json::parse(text);
    if (in.at("format") != kFormat) return Error{Code::kDataLoss, "not a file of kernels (format " + in.at("format").dump() + ") fit them again: regolab gap emulate"};
    std::vector<Kernel> out;
    for (const Json& one : in.at("kernels")) {
      out.push_back({one.at("group").get<Groups>(), one.at("log_length").get<std::vector<double>>(), one.at("log_trend").get<double>(), one.at("log_noise").get<std::vector<double>>()});
    }
    return out;
  } catch (const std::exception& problem) {  // the library's only way to say that a file is damaged
    return Error{Code::kDataLoss, std::string("kernels cannot be read (") + problem.what() + ") fit them again: regolab gap emulate"};
  }
}

const Result<Emulator>& shipped_emulator() {
  static const Result<Emulator> emulator = build_shipped();
  return emulator;
}

}  // namespace regolab::gap
