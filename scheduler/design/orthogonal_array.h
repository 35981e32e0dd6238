/// Orthogonal arrays of strength 2, constructed, not pasted. Sources: Hedayat, Sloane, Stufken, Orthogonal Arrays (1999),
/// chapters 3 (linear arrays), 6 (difference schemes), 7 (Hadamard) and 9 (mixed levels).
#pragma once
#include <span>
#include <string>
#include <vector>

namespace regolab {

struct OrthogonalArray {
  std::string name;                    ///< "L32 (4^9 2^1)"
  std::vector<int> levels;             // [n_columns]
  std::vector<std::vector<int>> rows;  // [n_rows][n_columns], 0-based levels, sorted
};

/// All built-in arrays, fewest rows first. L4, L8, L9, L12, L16, L18, L25, L27, L32, L49, L64, L81 with their mixed forms.
std::span<const OrthogonalArray> built_in_arrays();

/// "4^9 2^1" for {4,4,4,4,4,4,4,4,4,2}.
std::string level_formula(std::span<const int> levels);

/// Every combination of levels, the first column slowest. REQUIRES: the product of `levels` fits in memory.
OrthogonalArray full_factorial(std::span<const int> levels);

}  // namespace regolab
