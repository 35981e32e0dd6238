/// CSV as RFC 4180 has it: UTF-8, units in the header, every digit.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "client/wire.h"

namespace regolab::client {

/// Quoted when it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);
std::string csv_line(const std::vector<std::string>& fields);

/// point, seed, a column per factor, a column per response, and last `missing`: "repose_angle: not settled (...); ...".
/// Numbers in door units; a missing cell is empty. Bit-equal results give byte-equal text.
std::string results_csv(const pb::ResultsReply& results);

/// response, unit, mean, residual spread; factor, its range and ANOVA; level, runs, K, k and half width. A line per level; what
/// belongs to a response or a factor stands on each of its lines.
std::string range_csv(const pb::RangeReply& range);

/// Two columns in door units, header `axial_strain,sigma1_kPa`.
std::string curve_csv(const pb::Curve& curve);

}  // namespace regolab::client
