/// Reading the messages of a refused file, as its author would.
#pragma once
#include <gmock/gmock.h>

#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "input/diagnostic.h"

namespace regolab {

inline void PrintTo(const Diagnostic& diagnostic, std::ostream* out) { *out << to_text(diagnostic); }

namespace testing_support {

inline std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A diagnostic at line:column whose text has `part` in it.
inline auto at(int line, int column, const std::string& part) {
  return ::testing::AllOf(::testing::Field("line", &Diagnostic::line, line),
                          ::testing::Field("column", &Diagnostic::column, column),
                          ::testing::Field("text", &Diagnostic::text, ::testing::HasSubstr(part)));
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace testing_support
}  // namespace regolab
