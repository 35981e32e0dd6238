#include "store/artifact_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace regolab {
namespace {

namespace fs = std::filesystem;

Error os_error(const std::string& what, int number) {
  const bool full = number == ENOSPC || number == EDQUOT;
  return {full ? Code::kResourceExhausted : Code::kDataLoss,
          what + " (" + std::strerror(number) + "), " + (full ? "free some disk space" : "check the disk")};
}

Result<void> sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return os_error("cannot open " + folder.string(), errno);
  const int synced = fsync(descriptor);
  const int number = errno;
  close(descriptor);
  if (synced != 0) return os_error("cannot make " + folder.string() + " durable", number);
  return {};
}

}  // namespace

Result<ArtifactFiles> ArtifactFiles::open(const std::string& root) {
  std::error_code error;
  fs::remove_all(fs::path(root) / "incoming", error);
  for (const char* folder : {"cas", "incoming"}) {
    fs::create_directories(fs::path(root) / folder, error);
    if (error) return os_error("cannot create " + root + "/" + folder, error.value());
  }
  return ArtifactFiles{root};
}

std::string ArtifactFiles::path_of(const std::string& digest) const {
  return root_ + "/cas/" + digest.substr(0, 2) + "/" + digest.substr(2);
}

Result<ArtifactFiles::Upload> ArtifactFiles::begin(const std::string& digest) const {
  static std::atomic<unsigned> counter{0};
  if (!is_digest(digest)) return invalid("digest '" + digest + "' is not a SHA-256 (64 lower-case hex digits expected)");
  const std::string temporary = root_ + "/incoming/" + digest + "." + std::to_string(counter++);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0) return os_error("cannot create " + temporary, errno);
  return Upload{descriptor, temporary, path_of(digest), digest};
}

ArtifactFiles::Upload::Upload(int descriptor, std::string temporary, std::string final_path, std::string digest)
    : descriptor_(descriptor),
      temporary_(std::move(temporary)),
      final_path_(std::move(final_path)),
      digest_(std::move(digest)) {}

ArtifactFiles::Upload::Upload(Upload&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      temporary_(std::exchange(other.temporary_, {})),
      final_path_(std::move(other.final_path_)),
      digest_(std::move(other.digest_)),
      sum_(std::move(other.sum_)),
      size_(other.size_) {}

ArtifactFiles::Upload::~Upload() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

Result<void> ArtifactFiles::Upload::add(std::string_view bytes) {
  sum_.add(bytes);
  size_ += bytes.size();
  while (!bytes.empty()) {
    const auto written = write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return os_error("cannot write " + temporary_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> ArtifactFiles::Upload::finish() {
  if (const std::string found = sum_.hex(); found != digest_) {
    return Error{Code::kDataLoss,
                 "upload damaged (its SHA-256 is " + found + ", announced was " + digest_ + "), send it again"};
  }
  if (fsync(descriptor_) != 0) return os_error("cannot make " + temporary_ + " durable", errno);
  const fs::path final_path{final_path_};
  std::error_code error;
  fs::create_directories(final_path.parent_path(), error);
  if (error) return os_error("cannot create " + final_path.parent_path().string(), error.value());
  if (rename(temporary_.c_str(), final_path_.c_str()) != 0) return os_error("cannot rename " + temporary_, errno);
  temporary_.clear();
  if (auto synced = sync_folder(final_path.parent_path()); !synced.ok()) return synced;
  return sync_folder(final_path.parent_path().parent_path());
}

bool ArtifactFiles::has(const std::string& digest) const {
  std::error_code error;
  return is_digest(digest) && fs::exists(path_of(digest), error);
}

Result<std::string> ArtifactFiles::read(const std::string& digest) const {
  if (!is_digest(digest)) return invalid("digest '" + digest + "' is not a SHA-256 (64 lower-case hex digits expected)");
  std::ifstream file{path_of(digest), std::ios::binary};
  if (!file) return Error{Code::kNotFound, "artifact " + digest + " is not stored"};
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (sha256_hex(bytes) == digest) return bytes;
  std::error_code error;
  fs::rename(path_of(digest), root_ + "/" + digest + ".damaged", error);
  return Error{Code::kDataLoss, "artifact " + digest + " is damaged on disk (its SHA-256 changed), it was set aside"};
}

void ArtifactFiles::remove(const std::string& digest) const {
  std::error_code error;
  if (is_digest(digest)) fs::remove(path_of(digest), error);
}

std::vector<std::string> ArtifactFiles::list() const {
  std::vector<std::string> digests;
  std::error_code error;
  for (const auto& folder : fs::directory_iterator(root_ + "/cas", error)) {
    for (const auto& file : fs::directory_iterator(folder.path(), error)) {
      const std::string digest = folder.path().filename().string() + file.path().filename().string();
      if (is_digest(digest)) digests.push_back(digest);
    }
  }
  return digests;
}

}  // namespace regolab
