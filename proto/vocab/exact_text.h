/// Doubles as the shortest text that gives them back.
#pragma once
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace regolab {

inline std::string exact_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value);  // -0 and 0 are one value
  return {buffer, end.ptr};
}

inline std::optional<double> number_from_exact_text(std::string_view text) {
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace regolab
