/// What is wrong with a file, where, and what to do about it.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace regolab {

struct Diagnostic {
  std::string file;
  int line = 0;             ///< 1-based; 0 = the whole file
  int column = 0;           ///< 1-based
  std::string text;         ///< problem (why) remedy
  std::string source_line;  ///< for the caret
};

/// `file:line:column: text`, then the source line with a caret where there is one.
std::string to_text(const Diagnostic& diagnostic);

/// A value, or every reason why there is none.
template <class T>
struct Read {
  std::optional<T> value;
  std::vector<Diagnostic> diagnostics;
  bool ok() const { return value.has_value() && diagnostics.empty(); }
};

}  // namespace regolab
