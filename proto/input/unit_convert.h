/// Units as people write them, through UDUNITS-2. Safe from several threads.
#pragma once
#include <string>
#include <string_view>

#include "vocab/result.h"

namespace regolab {

/// Value in `si` of `value unit`. `unit` as UDUNITS reads it, and `deg`: "N s/m", "N.s/m", "kPa", "g/cm3", "cm/s2", "1".
/// Errors: kInvalidArgument ("5e4 N is a force, expected N/m (stiffness)"; unknown unit), kFailedPrecondition (no database).
/// `written` is how the file says value and unit, `what` the quantity wanted, both for the message.
Result<double> convert_to_si(double value, std::string_view written, std::string_view unit, std::string_view si,
                             std::string_view what);

}  // namespace regolab
