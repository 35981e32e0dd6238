/// Numbers as written, one at a time: unit, finiteness, range, error. Each problem at its place.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "scheduler/gap/quantities.h"
#include "scheduler/gap/raw_observation.h"

namespace regolab::gap {

/// "1.42 g/cm3".
std::string shown(double si, std::string_view unit);

/// Free text without control bytes.
std::string clean(std::string text);

/// Unit conversion is linear: one look-up serves a whole curve.
struct Scale {
  double factor = 1, offset = 0;
  double operator()(double value) const { return offset + factor * value; }
};

class NumberCheck {
 public:
  explicit NumberCheck(Report& report) : report_(report) {}

  /// From `unit` to SI; nothing when there is none, or it is another quantity's.
  std::optional<Scale> scale_of(const std::string& unit, Place place, std::string_view si, std::string_view what, const std::string& path, const std::string& written);
  bool finite(const RawNumber& number, const std::string& path);
  /// In SI; nothing when it cannot be measured.
  std::optional<double> checked(const RawNumber& number, const std::optional<Scale>& scale, const Quantity& q, const std::string& path);
  bool is_error(const RawNumber& number, const std::string& path);
  /// In SI.
  std::optional<double> error_of(const std::optional<RawNumber>& number, const std::optional<Scale>& scale, const std::string& path);

 private:
  bool in_range(double si, const RawNumber& number, const Quantity& q, const std::string& path);

  Report& report_;
};

}  // namespace regolab::gap
