/// The key that truths are sealed with: 64 hexadecimal digits in a file that only its owner can read, outside the set's folder.
#pragma once
#include <filesystem>
#include <string>

#include "client/outcome.h"

namespace regolab::client {

/// Where the key of a set is when nobody says: beside the folder.
std::filesystem::path default_key_file(const std::filesystem::path& set_folder);

/// Fresh from the system's entropy, mode 0600. An existing key is taken as it is, so that several sets may share one.
Outcome make_key(const std::filesystem::path& file, const std::filesystem::path& set_folder, std::string& key);

/// Refused: inside the set's folder, readable by others, not a key.
Outcome read_key(const std::filesystem::path& file, const std::filesystem::path& set_folder, std::string& key);

}  // namespace regolab::client
