/// Whole files or none: a reader, or a run that was killed, never meets half of one.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "vocab/result.h"

namespace regolab {

/// Writes beside `path`, flushes to the disk, then renames over it. Errors: kResourceExhausted (disk or quota full),
/// kFailedPrecondition (not writable), kInternal (input/output failure); the old file, if any, is left as it was.
Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// Errors: kNotFound, kFailedPrecondition (not readable, a folder), kInternal.
Result<std::string> read_whole_file(const std::filesystem::path& path);

/// Makes the folder and its parents, and proves by a small file that it can be written.
Result<void> make_writable_folder(const std::filesystem::path& path);

}  // namespace regolab
