/// Small result tables for tests of range analysis.
#pragma once
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "vocab/result_table.h"

namespace regolab::testing_support {

/// Factors A, B, C, ... with levels "1", "2", ...; one row per entry of `rows` (0-based levels) and `y` (response "y", unit
/// 1). A value that is not a number is missing, "not measured".
inline ResultTable table_of(const std::vector<int>& levels, const std::vector<std::vector<int>>& rows,
                            const std::vector<double>& y) {
  ResultTable table;
  table.experiment = "test";
  table.responses = {{"y", "1"}};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    TableFactor factor{.name = std::string(1, static_cast<char>('A' + i)), .unit = "1", .levels = {}};
    for (int level = 1; level <= levels[i]; ++level) factor.levels.push_back(std::to_string(level));
    table.factors.push_back(std::move(factor));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TableRow row{.point = static_cast<int>(i) + 1, .seed = 1, .level = rows[i], .value = {}, .missing = {}};
    if (std::isnan(y[i]))
      row.missing["y"] = "not measured";
    else
      row.value["y"] = y[i];
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// L9 (3^4) with its first `columns` columns.
inline std::vector<std::vector<int>> l9_rows(std::size_t columns) {
  std::vector<std::vector<int>> rows;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const std::vector<int> all{a, b, (a + b) % 3, (a + 2 * b) % 3};
      rows.emplace_back(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(columns));
    }
  }
  return rows;
}

}  // namespace regolab::testing_support
