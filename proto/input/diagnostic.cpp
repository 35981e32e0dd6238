#include "input/diagnostic.h"

#include <algorithm>

namespace regolab {
namespace {

constexpr std::size_t kWidth = 160;  // of the shown part of a source line

bool continues_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The source line and a caret below the column; long lines show the part around it.
std::string with_caret(const std::string& line, std::size_t column) {
  const std::size_t at = std::min(column - 1, line.size());
  const std::size_t from = at < kWidth - 20 ? 0 : at - kWidth / 2;
  std::string shown = line.substr(from, kWidth);
  std::string below;
  for (std::size_t i = 0; i < at - from && i < shown.size(); ++i) {
    if (!continues_letter(shown[i])) below += ' ';  // one space a letter, not a byte
  }
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  return "\n  " + shown + "\n  " + below + "^";
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file + ":";
  if (diagnostic.line > 0) {
    text += std::to_string(diagnostic.line) + ":" + std::to_string(std::max(diagnostic.column, 1)) + ":";
  }
  text += " " + diagnostic.text;
  if (diagnostic.line > 0 && diagnostic.column > 0 && !diagnostic.source_line.empty()) {
    text += with_caret(diagnostic.source_line, static_cast<std::size_t>(diagnostic.column));
  }
  return text;
}

}  // namespace regolab
