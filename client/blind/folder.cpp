#include "client/blind/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "client/file_read.h"
#include "client/file_write.h"
#include "digest/sha256.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr const char* kFormat = "regolab.blind-set/1";
constexpr const char* kTruth = ".json";
constexpr const char* kAnswer = ".answer.json";
constexpr std::string_view kWhole = "# SHA-256 of the lines above: ";
constexpr std::size_t kLargestList = 64 << 20;  // [bytes]

/// "<sha256>  <id><ending>", as sha256sum reads it.
std::string line_of(const Digest& d, const char* ending) { return d.sha256 + "  " + d.id + ending + "\n"; }

std::string lines_of(const std::vector<Digest>& list, const char* ending) {
  std::string out;
  for (const Digest& d : list) out += line_of(d, ending);
  return out;
}

std::vector<Digest> list_from(const std::string& text, std::string_view ending) {
  std::vector<Digest> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#' || line.size() < 66 + ending.size() || !line.ends_with(ending) || lines.eof())
      continue;  // a torn last line does not count
    out.push_back({line.substr(66, line.size() - 66 - ending.size()), line.substr(0, 64)});
  }
  return out;
}

Outcome read_if_there(const fs::path& path, std::string& text) {
  text.clear();
  std::error_code ignored;
  return fs::exists(path, ignored) ? read_whole_file(path, kLargestList, "a list of a blind set", text) : done();
}

Outcome make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  return error ? failed(Exit::kInternal, fmt::format("cannot make {} ({}) choose another place", path.string(), error.message())) : done();
}

Outcome set_from(const fs::path& file, const std::string& text, BlindSet& set) {
  const Json j = Json::parse(text, nullptr, false);
  if (!j.is_object() || j.value("format", "") != kFormat) {
    return failed(Exit::kInvalidInput,
                  fmt::format("{} (no blind set of this version) take a folder that `regolab gap blind make` made", file.string()));
  }
  set = {.cases = j.value("cases", 0U), .nulls = j.value("extra_nulls", 0U), .specimens = j.value("specimens", 0U), .seed = {}};
  if (j.contains("seed") && j["seed"].is_number_unsigned()) set.seed = j["seed"].get<std::uint64_t>();
  return done();
}

std::string header_of(const BlindSet& set) {
  return set.seed ? fmt::format("# development set, seed {}: its truths are known, no part of any record\n", *set.seed)
                  : "# blind set: SHA-256 of truths that are not revealed yet\n";
}

}  // namespace

BlindFolder::~BlindFolder() {
  if (lock_ >= 0) close(lock_);
}

Outcome BlindFolder::lock(bool make) {
  std::error_code ignored;
  if (!make && !fs::exists(path_ / "set.json", ignored)) {
    return failed(Exit::kInvalidInput,
                  fmt::format("{} holds no blind set (no set.json) make one: regolab gap blind make {}", path_.string(), path_.string()));
  }
  if (make && !drawn() && fs::exists(path_, ignored) && !fs::is_empty(path_, ignored) && !fs::exists(path_ / "lock", ignored)) {
    return failed(Exit::kInvalidInput, fmt::format("{} holds other files (a blind set has a folder of its own) choose another DIR", path_.string()));
  }
  if (make) {
    for (const char* inner : {"sealed", "cases"}) {
      if (auto made = make_folder(path_ / inner); !made.ok()) return made;
    }
  }
  lock_ = open((path_ / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0)
    return failed(Exit::kInternal,
                  fmt::format("cannot open {} ({}) choose a folder that can be written", (path_ / "lock").string(), std::strerror(errno)));
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) return done();
  return failed(Exit::kUsage, fmt::format("{} is in use (another `regolab gap blind` works on it) wait for it", path_.string()));
}

bool BlindFolder::drawn() const {
  std::error_code ignored;
  return fs::exists(path_ / "set.json", ignored);
}

Outcome BlindFolder::write_set(const BlindSet& set, const std::vector<Digest>& commitments,
                               const std::vector<std::pair<std::string, std::string>>& sealed) {
  for (const auto& [id, bytes] : sealed) {
    if (auto written = write_file(sealed_file(id), bytes); !written.ok()) return written;
  }
  const std::string lines = header_of(set) + lines_of(commitments, kTruth);
  if (auto written = write_file(path_ / "commitments", lines + std::string(kWhole) + sha256_hex(lines) + "\n"); !written.ok()) return written;
  Json j{{"format", kFormat},        {"development", set.seed.has_value()}, {"seed", set.seed ? Json(*set.seed) : Json()}, {"cases", set.cases},
         {"extra_nulls", set.nulls}, {"specimens", set.specimens}};
  if (auto written = write_file(path_ / "set.json", j.dump(1) + "\n"); !written.ok()) return written;
  return read();
}

std::string BlindFolder::list_digest() const { return sha256_hex(header_of(set_) + lines_of(commitments_, kTruth)); }

Outcome BlindFolder::read() {
  std::string text;
  if (auto got = read_whole_file(path_ / "set.json", kLargestList, "a blind set", text); !got.ok()) return got;
  if (auto got = set_from(path_ / "set.json", text, set_); !got.ok()) return got;
  if (auto got = read_whole_file(path_ / "commitments", kLargestList, "a list of commitments", text); !got.ok()) return got;
  commitments_ = list_from(text, kTruth);
  if (text.find(std::string(kWhole) + list_digest()) == std::string::npos) {
    return failed(Exit::kInvalidInput, fmt::format("{} (its lines are not those its own digest was made of: it was changed) restore it",
                                                   (path_ / "commitments").string()));
  }
  if (auto got = read_if_there(path_ / "answers", text); !got.ok()) return got;
  answers_ = list_from(text, kAnswer);
  torn_ = !text.empty() && text.back() != '\n';
  return done();
}

const Digest* BlindFolder::answer_of(const std::string& id) const {
  const auto found = std::ranges::find(answers_, id, &Digest::id);
  return found == answers_.end() ? nullptr : &*found;
}

Outcome BlindFolder::add_answer(const std::string& id, const std::string& text) {
  if (auto written = write_file(answer_file(id), text); !written.ok()) return written;
  const fs::path list = path_ / "answers";
  const Digest added{id, sha256_hex(text)};
  const int fd = open(list.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  int error = fd < 0 ? errno : 0;
  if (error == 0 && lseek(fd, 0, SEEK_END) == 0)
    error = write_all(fd, set_.seed ? "# development set: no part of any record\n" : "# SHA-256 of answers, in the order given\n");
  if (error == 0) error = write_all(fd, (torn_ ? "\n" : "") + line_of(added, kAnswer));
  if (error == 0 && fsync(fd) != 0) error = errno;
  if (fd >= 0) close(fd);
  if (error != 0)
    return failed(Exit::kInternal, fmt::format("cannot write {} ({}) make room; the case will be solved again", list.string(), std::strerror(error)));
  torn_ = false;
  answers_.push_back(added);
  return done();
}

Outcome BlindFolder::check_answers() const {
  for (const Digest& answer : answers_) {
    std::string text;
    if (auto got = read_whole_file(answer_file(answer.id), kLargestList, "an answer", text); !got.ok()) return got;
    if (sha256_hex(text) != answer.sha256) {
      return failed(Exit::kInvalidInput,
                    fmt::format("{} was changed (its SHA-256 is not the one in `answers`) restore it: there is one answer to a case",
                                answer_file(answer.id).string()));
    }
    if (std::ranges::count(answers_, answer.id, &Digest::id) > 1) {
      return failed(Exit::kInvalidInput, fmt::format("{}: case {} stands twice (there is one answer to a case) restore the list",
                                                     (path_ / "answers").string(), answer.id));
    }
  }
  return done();
}

bool lies_in(const fs::path& inner, const fs::path& folder) {
  std::error_code ignored;
  const fs::path a = fs::weakly_canonical(inner, ignored), b = fs::weakly_canonical(folder, ignored);
  return std::mismatch(b.begin(), b.end(), a.begin(), a.end()).first == b.end();
}

}  // namespace regolab::client
