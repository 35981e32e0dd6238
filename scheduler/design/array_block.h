/// The `array:` entry of a design file: a name, or rows of its own.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "input/diagnostic.h"
#include "input/map_reader.h"
#include "scheduler/design/factor_block.h"

namespace regolab {

struct ArrayRows {
  std::string name;                    ///< as shown: "L32 (4^9 2^1)", "L32, rows as given (4^8)", "table (3^2)"
  std::vector<int> column;             // [n_factors] 1-based column of the built-in array, 0 elsewhere
  std::vector<std::vector<int>> rows;  // [n_points][n_factors] level indices; empty when anything was reported
};

/// `array: auto | full | L32`, or a map with one of `rows: [[level, ...], ...]` (values as in `factors`, one row per point)
/// and `table: file.csv`, and with `name: L32` where such rows must be an orthogonal array of that many runs. Default auto.
/// A table may bring factors of its own. Messages about a table go to `elsewhere` under the table's name.
ArrayRows read_array(MapReader& top, DampingUnit damping, const std::map<std::string, std::string>& attachments,
                     std::vector<FactorLevels>& factors, Report& report, std::vector<Diagnostic>& elsewhere);

}  // namespace regolab
