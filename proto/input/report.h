/// Collects everything that is wrong with one file, each thing at its place.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "input/diagnostic.h"

namespace regolab {

/// 1-based; line 0 = the whole file.
struct Place {
  int line = 0;
  int column = 0;

  bool operator==(const Place&) const = default;
};

class Report {
 public:
  /// `text` is the file's content, for the source lines of the messages; copied.
  Report(std::string file, std::string_view text);

  void add(Place place, std::string text);

  /// Sorted by place; beyond kMost problems one closing line counts the rest.
  std::vector<Diagnostic> take();

  bool empty() const { return diagnostics_.empty(); }
  std::size_t size() const { return diagnostics_.size(); }

  static constexpr std::size_t kMost = 50;

 private:
  std::string file_;
  std::vector<std::string> lines_;
  std::vector<Diagnostic> diagnostics_;
};

/// A piece of input fit for a message: control bytes shown as '?', at most 60 bytes.
std::string excerpt(std::string_view text);

}  // namespace regolab
