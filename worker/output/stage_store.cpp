#include "worker/output/stage_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "digest/sha256.h"
#include "worker/output/atomic_file.h"
#include "worker/output/result_json.h"

namespace regolab {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Error other_job(const fs::path& directory, const std::string& what) {
  return {Code::kAlreadyExists, directory.string() + ": is in use (" + what + ") choose another folder, or empty this one"};
}

/// How the job with this key ended, by a result.json; nothing when that is of another job or none of ours.
std::optional<StageEnd> end_in(const std::string& text, const std::string& key) {
  const Json json = Json::parse(text, nullptr, false);
  const auto text_at = [&](const char* name) {
    return json.is_object() && json.contains(name) && json[name].is_string() ? json[name].get<std::string>() : std::string();
  };
  if (text_at("job_key") != key) return std::nullopt;
  return end_named(text_at("end"));
}

}  // namespace

Result<StageStore> StageStore::open(const fs::path& directory, const Job& job) {
  if (auto made = make_writable_folder(directory); !made) return made.error();
  const fs::path folder = directory / ".checkpoint";
  if (auto made = make_writable_folder(folder); !made) return made.error();
  const int lock = ::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock < 0) {
    return Error{Code::kFailedPrecondition,
                 folder.string() + ": cannot be locked (" + std::strerror(errno) + ") choose another folder"};
  }
  StageStore store(folder, lock);
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    return Error{Code::kFailedPrecondition,
                 directory.string() + ": is in use (another run works in it) wait for it, or choose another folder"};
  }
  if (auto claimed = store.claim(directory, job); !claimed) return claimed.error();
  return store;
}

Result<void> StageStore::claim(const fs::path& directory, const Job& job) {
  const std::string key = job_key(job);
  const fs::path job_file = folder_ / "job";
  const auto unfinished = read_whole_file(job_file);
  if (unfinished && *unfinished != key) return other_job(directory, "an unfinished run of another job stands in it");
  if (const auto result = read_whole_file(directory / "result.json")) {
    end_before_ = end_in(*result, key);
    if (!unfinished) clear();
    if (!end_before_) return other_job(directory, "its result.json is of another job");
    return {};
  }
  std::error_code code;
  if (!unfinished && fs::exists(directory / "observations.yaml", code)) {
    clear();
    return other_job(directory, "its observations.yaml would be overwritten");
  }
  return write_whole_file(job_file, key);
}

StageStore::StageStore(StageStore&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)), end_before_(other.end_before_) {}

StageStore::~StageStore() {
  if (lock_ >= 0) ::close(lock_);
}

fs::path StageStore::file(const StageSpec& spec, const char* ending) const { return folder_ / (stage_key(spec) + ending); }

std::optional<KeptStage> StageStore::finished(const StageSpec& spec) const {
  const auto record = read_whole_file(file(spec, ".json"));
  if (!record) return std::nullopt;
  const Json json = Json::parse(*record, nullptr, false);
  auto stage = stage_from_json(json, spec);
  auto state = read_whole_file(file(spec, ".state"));
  if (!stage || !state || json.value("state_sha256", "") != sha256_hex(*state)) return std::nullopt;
  return KeptStage{std::move(*stage), std::move(*state)};
}

Result<void> StageStore::keep(const KeptStage& kept) const {
  const StageSpec& spec = kept.stage.spec;
  if (auto written = write_whole_file(file(spec, ".state"), kept.state); !written) return written;
  Json json = stage_to_json(kept.stage);
  json["state_sha256"] = sha256_hex(kept.state);
  const std::string record = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (auto written = write_whole_file(file(spec, ".json"), record); !written) return written;
  drop_checkpoint(spec);
  return {};
}

std::string StageStore::checkpoint(const StageSpec& spec) const {
  auto bytes = read_whole_file(file(spec, ".partial"));
  return bytes ? std::move(*bytes) : std::string();
}

Result<void> StageStore::save_checkpoint(const StageSpec& spec, const std::string& bytes) const {
  return write_whole_file(file(spec, ".partial"), bytes);
}

void StageStore::drop_checkpoint(const StageSpec& spec) const {
  std::error_code code;
  fs::remove(file(spec, ".partial"), code);
}

void StageStore::clear() {
  std::error_code code;  // what cannot be removed does no harm: it belongs to this job
  fs::remove_all(folder_, code);
}

}  // namespace regolab
