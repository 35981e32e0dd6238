#include "client/file_write.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace regolab::client {
namespace {

Outcome cannot(const std::filesystem::path& path, int error) {
  const char* remedy = error == ENOSPC ? "make room" : "choose another place";
  return failed(Exit::kInternal, fmt::format("cannot write {} ({}) {}; nothing half-written is left", path.string(),
                                             std::strerror(error), remedy));
}

}  // namespace

int write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(fd, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

Outcome write_file(const std::filesystem::path& path, std::string_view text) {
  const std::string temporary = fmt::format("{}.part-{}", path.string(), getpid());
  const int fd = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) return cannot(path, errno);
  int error = write_all(fd, text);
  if (error == 0 && fsync(fd) != 0) error = errno;
  if (close(fd) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return done();
  unlink(temporary.c_str());
  return cannot(path, error);
}

}  // namespace regolab::client
