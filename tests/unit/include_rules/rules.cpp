#include "unit/include_rules/rules.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace regolab::test {

const std::vector<FolderRule>& folder_rules() {
  static const std::vector<FolderRule> rules{
      {"proto/vocab", {"vocab/"}},
      {"proto/digest", {"vocab/", "digest/"}},
      {"proto/seal", {"vocab/", "seal/"}},
      {"proto/input", {"vocab/", "input/"}},
      {"proto/apparatus", {"vocab/", "apparatus/"}},
      {"proto/rpc", {"vocab/", "rpc/", "regolab/v1/"}},
      {"worker/dem/simd", {"vocab/", "worker/dem/simd/"}},
      {"worker/dem/laws", {"vocab/", "worker/dem/simd/", "worker/dem/laws/"}},
      {"worker/dem", {"vocab/", "worker/dem/"}},
      {"worker/generate", {"vocab/", "worker/dem/", "worker/generate/"}},
      {"worker/effects", {"vocab/", "worker/dem/", "worker/effects/"}},
      {"worker/bench", {"vocab/", "worker/dem/", "worker/generate/", "worker/bench/"}},
      {"worker/protocol", {"vocab/", "apparatus/", "worker/dem/", "worker/generate/", "worker/effects/", "worker/protocol/"}},
      {"worker/stage", {"vocab/", "digest/", "apparatus/", "worker/dem/", "worker/generate/", "worker/effects/", "worker/protocol/", "worker/stage/"}},
      {"worker/output", {"vocab/", "digest/", "input/", "worker/stage/run_stage.h", "worker/output/"}},
      {"worker/rpc", {"vocab/", "digest/", "rpc/", "regolab/v1/", "worker/stage/run_stage.h", "worker/rpc/"}},
      {"worker", {"vocab/", "worker/bench/", "worker/stage/run_stage.h", "worker/output/", "worker/rpc/"}},
      {"scheduler/design", {"vocab/", "input/", "scheduler/design/"}},
      {"scheduler/queue", {"vocab/", "digest/", "scheduler/queue/"}},
      {"scheduler/analysis", {"vocab/", "scheduler/analysis/"}},
      {"scheduler/surrogate", {"vocab/", "input/", "digest/", "scheduler/random/", "scheduler/analysis/", "scheduler/surrogate/"}},
      {"scheduler/gap", {"vocab/", "input/", "digest/", "scheduler/random/", "scheduler/gap/"}},
      {"scheduler/gap/blind", {"vocab/", "input/", "digest/", "apparatus/", "scheduler/gap/"}},
      {"scheduler/solver", {"vocab/", "input/", "digest/", "scheduler/gap/", "scheduler/solver/"}},
      {"scheduler", {"vocab/", "digest/", "apparatus/", "input/", "rpc/", "regolab/v1/", "scheduler/", "store/"}},
      {"store", {"vocab/", "digest/", "store/", "schema.h"}},
      {"client", {"vocab/", "input/", "digest/", "seal/", "rpc/", "regolab/v1/", "client/"}},
  };
  return rules;
}

const std::vector<LibraryRule>& library_rules() {
  static const std::vector<LibraryRule> rules{
      {"gRPC and protobuf",
       {"grpc", "google/protobuf", "google/rpc"},
       {"proto/rpc", "worker/rpc", "scheduler/rpc", "client"}},
      {"generated types", {"regolab/v1/"}, {"proto/rpc", "worker/rpc", "scheduler/rpc", "client"}},
      {"sqlite", {"sqlite3"}, {"store"}},
      {"spdlog", {"spdlog/"}, {"worker/rpc", "scheduler/rpc", "scheduler/main.cpp", "client"}},
      {"fmt", {"fmt/"}, {"worker/rpc", "scheduler/rpc", "scheduler/main.cpp", "client"}},
  };
  return rules;
}

const std::vector<BannedRule>& banned_rules() {
  static const std::vector<BannedRule> rules{
      {"a clock (results must not depend on time)",
       {"worker/dem", "worker/generate", "worker/protocol", "scheduler/design", "scheduler/queue", "scheduler/analysis",
        "scheduler/surrogate", "scheduler/gap"},
       {"chrono", "ctime", "time.h", "sys/time.h"},
       {"steady_clock", "system_clock", "gettimeofday", "clock_gettime"}},
      {"the standard's random numbers (they differ between libraries)",
       {"worker", "scheduler/design", "scheduler/analysis", "scheduler/surrogate", "scheduler/gap"},
       {"random"},
       {"std::mt19937", "uniform_real_distribution", "normal_distribution", "std::rand", "random_device"}},
      {"printing (libraries return text)",
       {"worker/dem", "worker/generate", "worker/protocol", "worker/stage", "scheduler/design", "scheduler/queue",
        "scheduler/analysis", "scheduler/surrogate", "scheduler/gap", "store", "proto"},
       {"iostream", "print"},
       {"std::cout", "std::cerr", "std::printf", "fprintf(", "puts("}},
  };
  return rules;
}

namespace {

bool starts_with_any(std::string_view text, const std::vector<std::string_view>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(), [&](std::string_view prefix) { return text.starts_with(prefix); });
}

/// True for "worker/dem" and "worker/dem/x.h", not for "worker/demolition/x.h".
bool below(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}
bool below_any(std::string_view path, const std::vector<std::string_view>& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](std::string_view folder) { return below(path, folder); });
}

const FolderRule* rule_of(std::string_view path) {
  const FolderRule* best = nullptr;
  for (const FolderRule& rule : folder_rules()) {
    if (below(path, rule.folder) && (!best || rule.folder.size() > best->folder.size())) best = &rule;
  }
  return best;
}

std::string without_comment(const std::string& line) { return line.substr(0, line.find("//")); }

/// What is wrong with one include; empty when nothing.
std::string breach_of_include(const std::string& path, const std::string& header, bool quoted) {
  for (const LibraryRule& rule : library_rules()) {
    if (starts_with_any(header, rule.headers) && !below_any(path, rule.allowed))
      return std::string(rule.name) + " has no place here";
  }
  for (const BannedRule& rule : banned_rules()) {
    const bool named = std::find(rule.headers.begin(), rule.headers.end(), header) != rule.headers.end();
    if (named && below_any(path, rule.folders)) return std::string(rule.name) + " has no place here";
  }
  if (!quoted) return "";
  const FolderRule* rule = rule_of(path);
  if (!rule) return "no rule covers this folder: add one";
  return starts_with_any(header, rule->ours) ? "" : std::string(rule->folder) + " may not include it";
}

std::string breach_of_line(const std::string& path, const std::string& line) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::smatch match;
  if (std::regex_search(line, match, include)) {
    const std::string why = breach_of_include(path, match[2], match[1] == "\"");
    return why.empty() ? "" : match[2].str() + " (" + why + ")";
  }
  const std::string code = without_comment(line);
  for (const BannedRule& rule : banned_rules()) {
    if (!below_any(path, rule.folders)) continue;
    for (const std::string_view word : rule.words) {
      if (code.find(word) != std::string::npos) {
        return std::string(word) + " (" + std::string(rule.name) + " has no place here)";
      }
    }
  }
  return "";
}

}  // namespace

std::vector<std::string> breaches_in(const std::string& path, const std::string& text) {
  std::vector<std::string> breaches;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string breach = breach_of_line(path, line);
    if (!breach.empty()) breaches.push_back(path + ":" + std::to_string(number) + ": " + breach);
  }
  return breaches;
}

Survey survey(const std::filesystem::path& repository) {
  Survey out;
  for (const char* top : {"proto", "worker", "scheduler", "store", "client"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(repository / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".h" && ending != ".cpp" && ending != ".in") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      ++out.files;
      const auto found = breaches_in(std::filesystem::relative(entry.path(), repository).generic_string(), text.str());
      out.breaches.insert(out.breaches.end(), found.begin(), found.end());
    }
  }
  return out;
}

}  // namespace regolab::test
