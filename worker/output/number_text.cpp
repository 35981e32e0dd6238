#include "worker/output/number_text.h"

#include <charconv>
#include <cmath>

namespace regolab {

std::string shortest_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

std::string yaml_number(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::string text = shortest_text(value);
  const auto exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

double shown_value(double si, double factor) {
  if (factor == 1.0 || !std::isfinite(si)) return si;
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, si * factor, std::chars_format::scientific, 14);
  double shown = 0;
  std::from_chars(buffer, end.ptr, shown);
  return shown;
}

}  // namespace regolab
