#include "input/number_text.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace regolab {
namespace {

std::string_view skip_spaces(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t");
  return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

}  // namespace

std::string number_text(double value) {
  char buffer[64];
  const auto rounded = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, 11);
  double number = value;
  std::from_chars(buffer, rounded.ptr, number);
  if (number == 0) return "0";
  const double size = std::abs(number);
  const bool plain = size >= 1e-5 && size < 1e12;
  const auto end = plain ? std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed)
                         : std::to_chars(buffer, buffer + sizeof buffer, number);
  return {buffer, end.ptr};
}

std::optional<LeadingNumber> leading_number(std::string_view text) {
  text = skip_spaces(text);
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '+' || negative)) text.remove_prefix(1);
  if (text.empty() || text.front() == '-') return std::nullopt;
  const bool yaml_word = text.front() == '.' && text.size() > 1 && (text[1] < '0' || text[1] > '9');  // .nan, .inf
  const std::string_view digits = yaml_word ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (yaml_word && std::isfinite(value)) return std::nullopt;
  if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
  const std::string_view rest = digits.substr(static_cast<std::size_t>(end - digits.data()));
  if (!std::isfinite(value) && error == std::errc{} && !rest.empty() && rest.front() != ' ')
    return std::nullopt;  // "information"
  return LeadingNumber{negative ? -value : value, skip_spaces(rest)};
}

}  // namespace regolab
