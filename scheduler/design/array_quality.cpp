#include "scheduler/design/array_quality.h"

#include <algorithm>

namespace regolab {
namespace {

using Columns = std::vector<std::size_t>;

/// Whether these columns hold every combination of their levels equally often.
bool evenly_filled(std::span<const int> levels, const std::vector<std::vector<int>>& rows, const Columns& columns) {
  std::size_t cells = 1;
  for (const std::size_t c : columns) cells *= static_cast<std::size_t>(levels[c]);
  if (cells == 0 || rows.size() % cells != 0) return false;
  std::vector<std::size_t> count(cells, 0);
  for (const auto& row : rows) {
    std::size_t cell = 0;
    for (const std::size_t c : columns) cell = cell * static_cast<std::size_t>(levels[c]) + static_cast<std::size_t>(row[c]);
    ++count[cell];
  }
  return std::ranges::all_of(count, [&](std::size_t n) { return n == rows.size() / cells; });
}

/// The first set of `size` columns that is not evenly filled.
std::optional<Columns> uneven_set(std::span<const int> levels, const std::vector<std::vector<int>>& rows, std::size_t size) {
  Columns columns(size);
  for (std::size_t i = 0; i < size; ++i) columns[i] = i;
  while (true) {
    if (!evenly_filled(levels, rows, columns)) return columns;
    std::size_t i = size;  // the next combination in lexicographic order
    while (i > 0 && columns[i - 1] == levels.size() - size + i - 1) --i;
    if (i == 0) return std::nullopt;
    ++columns[i - 1];
    for (std::size_t j = i; j < size; ++j) columns[j] = columns[j - 1] + 1;
  }
}

}  // namespace

ArrayQuality quality_of(std::span<const int> levels, const std::vector<std::vector<int>>& rows) {
  constexpr std::size_t kHighest = 3;
  ArrayQuality quality;
  for (std::size_t t = 1; t <= std::min(kHighest, levels.size()); ++t) {
    if (rows.empty() || uneven_set(levels, rows, t)) break;
    quality.strength = static_cast<int>(t);
  }
  quality.balanced = quality.strength >= 1;
  quality.error_degrees_of_freedom = static_cast<int>(rows.size()) - 1;
  for (const int n : levels) quality.error_degrees_of_freedom -= n - 1;
  return quality;
}

std::optional<std::pair<std::size_t, std::size_t>> unbalanced_pair(std::span<const int> levels,
                                                                   const std::vector<std::vector<int>>& rows) {
  if (levels.size() < 2) return std::nullopt;
  const auto set = uneven_set(levels, rows, 2);
  if (!set) return std::nullopt;
  return std::pair((*set)[0], (*set)[1]);
}

}  // namespace regolab
