/// Which array carries a study's factors, and which column each factor takes.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scheduler/design/orthogonal_array.h"
#include "vocab/result.h"

namespace regolab {

struct ChosenArray {
  std::string name;
  std::vector<int> column;             // [n_factors] 1-based; 0 for a full factorial
  std::vector<std::vector<int>> rows;  // [n_points][n_factors] 0-based levels
};

inline constexpr std::size_t kMostPoints = 4096;

/// `wanted`: "auto" (the smallest built-in array or full factorial that fits), "full", or a name: "L16", "L16 (4^5)".
/// A column of c levels takes a factor of f levels when f divides c: levels are then merged evenly and stay orthogonal.
/// Errors name what would fit.
Result<ChosenArray> choose_array(std::string_view wanted, std::span<const int> levels);

/// "L4 (2^3), L8 (2^7), ...": for messages.
std::string list_of_arrays();

}  // namespace regolab
