#include "scheduler/analysis/table_shape.h"

#include <algorithm>
#include <set>

namespace regolab::analysis {

bool well_formed(const ResultTable& table) {
  return std::ranges::all_of(table.rows, [&](const TableRow& row) {
    if (row.level.size() != table.factors.size()) return false;
    for (std::size_t i = 0; i < row.level.size(); ++i) {
      if (row.level[i] < 0 || static_cast<std::size_t>(row.level[i]) >= table.factors[i].levels.size()) return false;
    }
    return true;
  });
}

Result<ResultTable> without_points(ResultTable table, const std::vector<int>& points) {
  for (const int point : points) {
    if (std::ranges::find(table.rows, point, &TableRow::point) == table.rows.end())
      return Error{Code::kNotFound, "no point " + std::to_string(point) +
                                        " to leave out (the points are numbered from 1) name one of the table's"};
  }
  std::erase_if(table.rows, [&](const TableRow& row) { return std::ranges::find(points, row.point) != points.end(); });
  return table;
}

std::optional<std::string> scatters(const ResultTable& table) {
  std::set<int> points;
  for (const TableRow& row : table.rows) points.insert(row.point);
  std::size_t effects = 1;  // the mean
  const TableFactor* most = nullptr;
  std::size_t most_levels = 0;
  for (std::size_t i = 0; i < table.factors.size(); ++i) {
    std::set<int> used;
    for (const TableRow& row : table.rows) used.insert(row.level[i]);
    effects += used.empty() ? 0 : used.size() - 1;
    if (used.size() <= most_levels) continue;
    most = &table.factors[i];
    most_levels = used.size();
  }
  if (most == nullptr || effects <= points.size() || 2 * most_levels <= points.size()) return std::nullopt;
  return most->name + " has " + std::to_string(most_levels) + " levels at " + std::to_string(points.size()) + " points";
}

}  // namespace regolab::analysis
