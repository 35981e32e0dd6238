#include "worker/output/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace regolab {
namespace {

Error write_error(const std::filesystem::path& path, int code) {
  const std::string why = path.string() + ": cannot be written (" + std::strerror(code) + ")";
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return {Code::kResourceExhausted, why + " free some space, then start again: finished stages are kept"};
    case EACCES:
    case EPERM:
    case EROFS: return {Code::kFailedPrecondition, why + " choose a folder you may write to"};
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG:
    case ELOOP:
    case EISDIR:
    case EEXIST: return {Code::kFailedPrecondition, why + " choose another folder"};
    default: return {Code::kInternal, why + " check the disk"};
  }
}

/// Owns a file descriptor and, until released, the temporary file's name.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    failure_ = descriptor_ < 0 ? errno : 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_ && descriptor_ >= 0) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    while (failure_ == 0 && !bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written >= 0)
        bytes.remove_prefix(static_cast<std::size_t>(written));
      else if (errno != EINTR)
        failure_ = errno;
    }
  }
  void flush() {
    if (failure_ == 0 && ::fsync(descriptor_) != 0) failure_ = errno;
  }
  void rename_to(const std::filesystem::path& path) {
    if (failure_ != 0) return;
    if (::rename(path_.c_str(), path.c_str()) != 0)
      failure_ = errno;
    else
      renamed_ = true;
  }
  int failure() const { return failure_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  int failure_ = 0;
  bool renamed_ = false;
};

void flush_folder(const std::filesystem::path& folder) {  // so that the rename itself survives a power cut
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path beside = path;
  beside += ".part";
  TemporaryFile file(beside);
  file.write(bytes);
  file.flush();
  file.rename_to(path);
  if (file.failure() != 0) return write_error(path, file.failure());
  flush_folder(path.parent_path());
  return {};
}

Result<std::string> read_whole_file(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status))
    return Error{Code::kNotFound, path.string() + ": not there (no such file) check the name"};
  if (std::filesystem::is_directory(status)) {
    return Error{Code::kFailedPrecondition, path.string() + ": cannot be read (it is a folder) name a file"};
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    return Error{Code::kFailedPrecondition,
                 path.string() + ": cannot be read (" + std::strerror(errno) + ") check its permissions"};
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (in.bad()) return Error{Code::kInternal, path.string() + ": reading stopped (input/output failure) check the disk"};
  return std::move(bytes).str();
}

Result<void> make_writable_folder(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code) return write_error(path, code.value());
  const std::filesystem::path probe = path / ".probe";
  if (auto written = write_whole_file(probe, "regolab\n"); !written) return written.error();
  std::filesystem::remove(probe, code);
  return {};
}

}  // namespace regolab
