#include "client/blind/key_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "client/blind/folder.h"
#include "client/file_read.h"
#include "client/file_write.h"
#include "seal/random_bytes.h"
#include "seal/seal.h"

namespace regolab::client {

namespace fs = std::filesystem;

fs::path default_key_file(const fs::path& set_folder) {
  const fs::path plain = set_folder.has_filename() ? set_folder : set_folder.parent_path();
  return plain.string() + ".key";
}

Outcome make_key(const fs::path& file, const fs::path& set_folder, std::string& key) {
  std::error_code ignored;
  if (fs::exists(file, ignored)) return read_key(file, set_folder, key);
  if (lies_in(file, set_folder))
    return failed(Exit::kUsage,
                  fmt::format("--key {} lies in the set's folder (whoever has the cases would have the key) put it elsewhere", file.string()));
  const auto fresh = random_bytes(kKeyBytes);
  if (!fresh.ok()) return failed(Exit::kInternal, fresh.error().text);
  const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  int error = fd < 0 ? errno : write_all(fd, hex_text(*fresh) + "\n");
  if (error == 0 && fsync(fd) != 0) error = errno;
  if (fd >= 0) close(fd);
  if (error != 0)
    return failed(Exit::kInternal,
                  fmt::format("cannot write the key {} ({}) choose another place with --key FILE", file.string(), std::strerror(error)));
  key = *fresh;
  return done();
}

Outcome read_key(const fs::path& file, const fs::path& set_folder, std::string& key) {
  if (lies_in(file, set_folder))
    return failed(Exit::kUsage,
                  fmt::format("--key {} lies in the set's folder (whoever has the cases would have the key) move it elsewhere", file.string()));
  struct stat about {};
  if (stat(file.c_str(), &about) != 0)
    return failed(Exit::kInvalidInput,
                  fmt::format("cannot read the key {} ({}) name the key of this set with --key FILE", file.string(), std::strerror(errno)));
  if ((about.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return failed(Exit::kInvalidInput,
                  fmt::format("the key {} can be read by others (mode {:o}) chmod 600 it", file.string(), about.st_mode & 0777U));
  std::string text;
  if (auto got = read_whole_file(file, 1024, "a key", text); !got.ok()) return got;
  if (!text.empty() && text.back() == '\n') text.pop_back();
  const auto bytes = bytes_of_hex(text);
  if (!bytes.ok() || bytes->size() != kKeyBytes)
    return failed(Exit::kInvalidInput,
                  fmt::format("{} is no key (64 hexadecimal digits are wanted) name the key of this set with --key FILE", file.string()));
  key = *bytes;
  return done();
}

}  // namespace regolab::client
