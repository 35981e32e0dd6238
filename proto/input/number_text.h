/// Numbers to and from text, without locale.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace regolab {

/// At most 12 significant digits, no exponent between 1e-5 and 1e12: "0.1", "100000", "2.5e-06".
std::string number_text(double value);

struct LeadingNumber {
  double value = 0;       ///< may be infinite or not a number
  std::string_view rest;  ///< what follows, without spaces in front
};

/// The number `text` starts with; ".nan", "inf" and overflowing ones are numbers here, to be refused by name. Nothing when
/// the text does not start with one.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace regolab
