/// One response of a table, averaged over seeds: what the additive model is fitted to.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "vocab/result_table.h"

namespace regolab::analysis {

struct PointMean {
  int point = 0;
  std::vector<int> level;  // [n_factors]
  double value = 0;        ///< mean over its seeds, door unit
  int seeds = 0;           ///< that gave a value
};

struct PointMeans {
  std::string unit;                  ///< door unit
  std::vector<PointMean> points;     ///< those with at least one value, by point
  std::vector<std::string> missing;  ///< "point 7 seed 1: not settled (...)"
  int points_in_design = 0;
  std::optional<double> seed_standard_deviation;  ///< pooled within points
  int most_seeds = 0;
  int fewest_seeds = 0;  ///< of the points with a value
};

PointMeans point_means(const ResultTable& table, const TableResponse& response);

}  // namespace regolab::analysis
