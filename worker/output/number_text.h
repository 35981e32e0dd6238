/// Numbers as text that every reader takes back to the same bits.
#pragma once
#include <string>

namespace regolab {

/// Shortest decimal that reads back as the same double ("0.1", "1e+20"). NaN and infinities: "nan", "inf", "-inf".
std::string shortest_text(double value);

/// The same, spelled so that YAML 1.1 readers see a number too ("1.0e-05", ".nan", ".inf").
std::string yaml_number(double value);

/// value * factor, rounded to 15 digits, so that 1250 Pa is shown as 1.25 kPa and 0.35 rad not as 20.053522829578812.
/// For door units only; SI values are written in full.
double shown_value(double si, double factor);

}  // namespace regolab
