#include "client/file_read.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace regolab::client {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const fs::path& path, std::size_t limit, std::string& why) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    why = "it is a folder";
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    why = std::strerror(errno);
    return std::nullopt;
  }
  std::string text(limit + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

Outcome read_whole_file(const fs::path& path, std::size_t limit, const std::string& what, std::string& text) {
  const auto too_large = [&](const std::string& size) {
    return failed(Exit::kInvalidInput, fmt::format("{}: {} bytes (the limit is {} MiB, {} bytes) give means over repeats and curves of a few hundred points", path.string(),
                                                   size, limit >> 20, limit));
  };
  std::error_code error;
  if (const auto size = fs::file_size(path, error); !error && size > limit) return too_large(std::to_string(size));
  std::string why;
  auto read = read_file(path, limit, why);  // a pipe has no size: the limit holds there, too
  if (!read) return failed(Exit::kInvalidInput, fmt::format("{}: cannot be read ({}) name {}", path.string(), why, what));
  if (read->size() > limit) return too_large("more than " + std::to_string(limit));
  text = std::move(*read);
  return done();
}

}  // namespace regolab::client
