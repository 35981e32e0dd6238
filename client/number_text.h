/// Numbers for people (few digits) and for files (every digit).
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace regolab::client {

/// The shortest decimal that reads back to the same bits, so files of bit-equal runs are byte-equal.
std::string shortest(double value);

/// `digits` significant digits with trailing zeros kept: 1.7 -> "1.70", 12345.6 -> "12346". NaN -> "-".
std::string significant(double value, int digits);

/// Decimals that show the largest magnitude of a column with `digits` significant digits, for an aligned column.
int decimals_for(std::span<const double> column, int digits);

/// Fixed decimals; "-0.00" is written "0.00".
std::string fixed(double value, int decimals);

/// "3.47 ±0.12": two digits of the uncertainty decide the decimals of both; without one, four digits of the value.
std::string with_uncertainty(double value, std::optional<double> half_width);

/// "<0.001", "0.012", "0.25".
std::string p_text(double p);

/// "45 s", "12 min", "3 h 20 min".
std::string duration_text(double seconds);

/// "8.4 M", "120 k".
std::string large_count(double value);

/// The number a level's label is, when it is one ("0.1", "5e4"; not "mixture").
std::optional<double> as_number(std::string_view label);

}  // namespace regolab::client
