#include "client/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace regolab::client {
namespace {

constexpr int kMostDecimals = 9;

/// Position of the leading digit: 0 for 1..9.99, -2 for 0.01..0.0999.
int leading_place(double value) { return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)))); }

}  // namespace

std::string shortest(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool negative_zero = text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos;
  return negative_zero ? text.substr(1) : text;
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  const int place = leading_place(value);
  if (place < -5 || place > 8) return fmt::format("{:.{}e}", value, digits - 1);
  return fixed(value, std::max(0, digits - 1 - place));
}

int decimals_for(std::span<const double> column, int digits) {
  double largest = 0;
  for (const double value : column) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return std::clamp(digits - 1 - leading_place(largest), 0, kMostDecimals);
}

std::string with_uncertainty(double value, std::optional<double> half_width) {
  if (!half_width || !std::isfinite(*half_width) || *half_width <= 0) return significant(value, 4);
  const int decimals = std::clamp(1 - leading_place(*half_width), 0, kMostDecimals);
  return fmt::format("{} ±{}", fixed(value, decimals), fixed(*half_width, decimals));
}

std::string p_text(double p) {
  if (!std::isfinite(p)) return "-";
  if (p < 0.001) return "<0.001";
  return fixed(p, p < 0.1 ? 3 : 2);
}

std::string duration_text(double seconds) {
  const auto s = static_cast<long>(std::llround(std::max(0.0, seconds)));
  if (s < 100) return fmt::format("{} s", s);
  const long minutes = (s + 30) / 60;
  if (minutes < 100) return fmt::format("{} min", minutes);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

std::string large_count(double value) {
  if (value >= 1e9) return fmt::format("{:.1f} G", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.1f} M", value / 1e6);
  if (value >= 1e4) return fmt::format("{:.0f} k", value / 1e3);
  return fmt::format("{:.0f}", value);
}

std::optional<double> as_number(std::string_view label) {
  double value = 0;
  const auto [end, error] = std::from_chars(label.data(), label.data() + label.size(), value);
  if (error != std::errc() || end != label.data() + label.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace regolab::client
