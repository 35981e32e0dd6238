/// Files that are whole or not there.
#pragma once
#include <filesystem>
#include <string_view>

#include "client/outcome.h"

namespace regolab::client {

/// Through a temporary file beside it, synced and renamed: a full disk or a kill leaves the old file, or none.
Outcome write_file(const std::filesystem::path& path, std::string_view text);

/// Writes all of `text`, over interruptions. 0, or errno.
int write_all(int fd, std::string_view text);

}  // namespace regolab::client
