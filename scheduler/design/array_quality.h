/// Strength, balance and error degrees of freedom, by counting.
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scheduler/design/design.h"

namespace regolab {

/// `rows` [n_rows][n_columns] of 0-based levels below `levels` [n_columns].
ArrayQuality quality_of(std::span<const int> levels, const std::vector<std::vector<int>>& rows);

/// The first two columns that do not hold every pair of levels equally often; nothing when all do (strength 2).
std::optional<std::pair<std::size_t, std::size_t>> unbalanced_pair(std::span<const int> levels,
                                                                   const std::vector<std::vector<int>>& rows);

}  // namespace regolab
