#include "scheduler/analysis/point_means.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "vocab/units.h"

namespace regolab::analysis {
namespace {

struct Gathered {
  std::vector<int> level;
  std::vector<double> values;
};

std::string missing_line(const TableRow& row, const std::string& response, bool present) {
  const auto why = row.missing.find(response);
  const std::string reason = present ? "not a finite number" : why == row.missing.end() ? "no value" : why->second;
  return "point " + std::to_string(row.point) + " seed " + std::to_string(row.seed) + ": " + reason;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

PointMeans point_means(const ResultTable& table, const TableResponse& response) {
  const DoorUnit unit = door_unit(response.unit);
  PointMeans means{.unit = std::string(unit.name), .points = {}, .missing = {}, .seed_standard_deviation = {}};
  std::map<int, Gathered> by_point;
  for (const TableRow& row : table.rows) {
    Gathered& gathered = by_point[row.point];
    gathered.level = row.level;
    const auto value = row.value.find(response.id);
    const bool present = value != row.value.end();
    if (present && std::isfinite(value->second)) {
      gathered.values.push_back(value->second * unit.factor);
    } else {
      means.missing.push_back(missing_line(row, response.id, present));
    }
  }
  means.points_in_design = static_cast<int>(by_point.size());
  double within = 0;  // sum of squares of seeds about their point's mean
  int within_df = 0;
  for (const auto& [point, gathered] : by_point) {
    if (gathered.values.empty()) continue;
    const double mean = mean_of(gathered.values);
    const int seeds = static_cast<int>(gathered.values.size());
    for (const double value : gathered.values) within += (value - mean) * (value - mean);
    within_df += seeds - 1;
    means.fewest_seeds = means.points.empty() ? seeds : std::min(means.fewest_seeds, seeds);
    means.most_seeds = std::max(means.most_seeds, seeds);
    means.points.push_back({point, gathered.level, mean, seeds});
  }
  if (within_df > 0) means.seed_standard_deviation = std::sqrt(within / within_df);
  return means;
}

}  // namespace regolab::analysis
