/// Curves for spreadsheets, R and pandas.
#pragma once
#include <string>

#include "vocab/measurement.h"

namespace regolab {

/// Two columns, the unit in the header: `axial_strain,sigma1_kPa`. Door units; numbers read back to 15 digits.
std::string curve_csv(const Curve& curve);

}  // namespace regolab
