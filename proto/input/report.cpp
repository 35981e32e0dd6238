#include "input/report.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace regolab {
namespace {

constexpr std::size_t kLongestLine = 4096;  // a longer line is shown cut: nobody reads it whole

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.emplace_back(line.substr(0, kLongestLine));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

Report::Report(std::string file, std::string_view text) : file_(std::move(file)), lines_(split_lines(text)) {}

void Report::add(Place place, std::string text) {
  std::string source;
  if (place.line >= 1 && static_cast<std::size_t>(place.line) <= lines_.size()) {
    source = lines_[static_cast<std::size_t>(place.line) - 1];
  }
  diagnostics_.push_back({file_, place.line, place.column, std::move(text), std::move(source)});
}

std::vector<Diagnostic> Report::take() {
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  if (diagnostics_.size() > kMost) {
    const std::size_t rest = diagnostics_.size() - kMost;
    diagnostics_.resize(kMost);
    diagnostics_.push_back(
        {file_, 0, 0, std::to_string(rest) + " more problems (not shown) mend the first ones and try again", ""});
  }
  return std::exchange(diagnostics_, {});
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kMostBytes = 60;
  std::string shown(text.substr(0, kMostBytes));
  if (text.size() > kMostBytes) {
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0) == 0x80) shown.pop_back();  // whole letters
    if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xC0) shown.pop_back();
    shown += "...";
  }
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return shown;
}

}  // namespace regolab
