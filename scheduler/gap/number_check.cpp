#include "scheduler/gap/number_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "input/number_text.h"
#include "input/unit_convert.h"
#include "vocab/units.h"

namespace regolab::gap {

std::string shown(double si, std::string_view unit) {
  const DoorUnit door = door_unit(unit);
  char digits[32];
  const int n = std::snprintf(digits, sizeof digits, "%.4g", si * door.factor);
  return std::string(digits, static_cast<std::size_t>(n)) + (unit == "1" ? "" : " " + std::string(door.name));
}

std::string clean(std::string text) {
  std::ranges::replace_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return text;
}

std::optional<Scale> NumberCheck::scale_of(const std::string& unit, Place place, std::string_view si, std::string_view what, const std::string& path, const std::string& written) {
  if (unit.empty()) {
    report_.add(place, excerpt(path) + " has no unit (numbers without one cannot be compared) write e.g. `unit: " + std::string(door_unit(si).name) + "`");
    return std::nullopt;
  }
  const std::string text = excerpt(written) + " " + unit;
  const auto zero = convert_to_si(0, text, unit, si, what), one = convert_to_si(1, text, unit, si, what);
  if (zero.ok() && one.ok()) return Scale{*one - *zero, *zero};
  report_.add(place, excerpt(path) + ": " + (zero.ok() ? one.error().text : zero.error().text));
  return std::nullopt;
}

bool NumberCheck::finite(const RawNumber& number, const std::string& path) {
  if (std::isfinite(number.value)) return true;
  report_.add(number.place, path + ": '" + excerpt(number.written) + "' is not a finite number (nothing can be compared with it) correct it, or leave the entry out");
  return false;
}

bool NumberCheck::in_range(double si, const RawNumber& number, const Quantity& q, const std::string& path) {
  if (std::isfinite(si) && (si > q.low || (q.low_too && si == q.low)) && si <= q.high * (1 + 1e-9)) return true;
  report_.add(number.place, path + ": " + excerpt(number.written) + " (a " + std::string(q.what) + (q.low_too ? " from " : " above ") + shown(q.low, q.si) + " to " +
                                shown(q.high, q.si) + " can be measured) check value and unit");
  return false;
}

std::optional<double> NumberCheck::checked(const RawNumber& number, const std::optional<Scale>& scale, const Quantity& q, const std::string& path) {
  if (!finite(number, path) || !scale) return std::nullopt;
  const double si = (*scale)(number.value);
  return in_range(si, number, q, path) ? std::optional(si) : std::nullopt;
}

bool NumberCheck::is_error(const RawNumber& number, const std::string& path) {
  if (!finite(number, path + ".standard_error")) return false;
  if (number.value >= 0) return true;
  report_.add(number.place, path + ": a standard error of " + excerpt(number.written) + " (must not be negative) give its size");
  return false;
}

std::optional<double> NumberCheck::error_of(const std::optional<RawNumber>& number, const std::optional<Scale>& scale, const std::string& path) {
  if (!number || !is_error(*number, path) || !scale) return std::nullopt;
  return std::abs(scale->factor) * number->value;
}

}  // namespace regolab::gap
