#include "store/lock_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace regolab {

Result<LockFile> LockFile::take(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    return Error{
        errno == ENOSPC ? Code::kResourceExhausted : Code::kFailedPrecondition,
        path + " could not be opened (" + std::strerror(errno) + "), check that the folder exists and may be written"};
  }
  LockFile lock{descriptor};
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    char pid[32] = {};
    const auto length = read(descriptor, pid, sizeof pid - 1);
    return Error{Code::kFailedPrecondition, "the database is in use (" + path + " is held by process " +
                                                std::string(pid, length > 0 ? static_cast<std::size_t>(length) : 0) +
                                                "), stop that scheduler or use its address with --server"};
  }
  const std::string pid = std::to_string(getpid());
  // The pid is only for the message above: a full disk must not keep the scheduler from starting.
  if (ftruncate(descriptor, 0) != 0 || write(descriptor, pid.data(), pid.size()) < 0) return lock;
  return lock;
}

LockFile::~LockFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace regolab
