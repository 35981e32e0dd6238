/// Files people name, read up to a limit.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "client/outcome.h"

namespace regolab::client {

/// The file's bytes, at most `limit` + 1 of them; else why not, in the system's words.
std::optional<std::string> read_file(const std::filesystem::path& path, std::size_t limit, std::string& why);

/// All of a file of at most `limit` bytes; a larger one is refused by its size, before it is read. `what` is what it should be.
Outcome read_whole_file(const std::filesystem::path& path, std::size_t limit, const std::string& what, std::string& text);

}  // namespace regolab::client
