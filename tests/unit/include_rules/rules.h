/// Who may include whom, as data, and the reader that finds breaches.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace regolab::test {

/// Files whose path starts with `folder` may include our own headers only from `ours`. The longest matching folder decides.
struct FolderRule {
  std::string_view folder;
  std::vector<std::string_view> ours;  ///< prefixes of quoted includes
};

/// Headers that start with one of `headers` may be included only by files below one of `allowed`.
struct LibraryRule {
  std::string_view name;  ///< for messages
  std::vector<std::string_view> headers;
  std::vector<std::string_view> allowed;
};

/// Files below one of `folders` must not contain any of `words` outside comments, nor include any of `headers`.
struct BannedRule {
  std::string_view name;
  std::vector<std::string_view> folders;
  std::vector<std::string_view> headers;
  std::vector<std::string_view> words;
};

const std::vector<FolderRule>& folder_rules();
const std::vector<LibraryRule>& library_rules();
const std::vector<BannedRule>& banned_rules();

/// `path` is relative to the repository; `text` the file's content. One line per breach: "path:line: what (why)".
std::vector<std::string> breaches_in(const std::string& path, const std::string& text);

/// Every .h, .cpp and .in of proto, worker, scheduler, store and client: their breaches, and how many files were read.
struct Survey {
  int files = 0;
  std::vector<std::string> breaches;
};
Survey survey(const std::filesystem::path& repository);

}  // namespace regolab::test
