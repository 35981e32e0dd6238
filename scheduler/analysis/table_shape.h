/// What a result table allows: which points it has, and whether its levels repeat enough for a range analysis.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::analysis {

/// A stored table whose rows do not fit its factors is damaged; nothing can be read from it.
bool well_formed(const ResultTable& table);

/// Error: kNotFound when the table has no such point.
Result<ResultTable> without_points(ResultTable table, const std::vector<int>& points);

/// "theta_F has 192 levels at 192 points" when the points scatter: more effects than points, and fewer than two points a
/// level of some factor. Then level means are single runs, in which all factors vary at once. REQUIRES: well_formed(table).
std::optional<std::string> scatters(const ResultTable& table);

}  // namespace regolab::analysis
