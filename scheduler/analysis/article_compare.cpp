#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "scheduler/analysis/article.h"
#include "scheduler/analysis/article_tables.h"
#include "scheduler/analysis/point_means.h"
#include "scheduler/analysis/range.h"

namespace regolab::analysis {
namespace {

/// "20" and "20 deg" are the number 20; "mixture" is no number.
bool same_level(const std::string& a, const std::string& b) {
  const double x = printed_number(a);
  const double y = printed_number(b);
  const auto starts_a_number = [](const std::string& text) {
    return !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
  };
  if (starts_a_number(a) != starts_a_number(b)) return false;
  if (!starts_a_number(a)) return a == b;
  return std::abs(x - y) <= 1e-6 * std::max(std::abs(x), std::abs(y));
}

/// The value of a parameter at a row: a factor's level or a fixed value; empty when the table does not say.
std::string parameter_at(const ResultTable& table, const TableRow& row, const std::string& name) {
  for (std::size_t i = 0; i < table.factors.size(); ++i) {
    if (table.factors[i].name != name || i >= row.level.size()) continue;
    const auto level = static_cast<std::size_t>(row.level[i]);
    if (level < table.factors[i].levels.size()) return table.factors[i].levels[level];
  }
  const auto fixed = table.fixed.find(name);
  return fixed == table.fixed.end() ? "" : fixed->second;
}

/// The article's test with this row's parameters, 0 when there is none.
int test_of(const ResultTable& table, const TableRow& row) {
  const ArticleDesign& design = article_design();
  for (std::size_t test = 0; test < design.rows.size(); ++test) {
    bool same = true;
    for (std::size_t i = 0; same && i < design.factors.size(); ++i) {
      same = same_level(parameter_at(table, row, design.factors[i]),
                        design.levels[i][static_cast<std::size_t>(design.rows[test][i])]);
    }
    if (same) return static_cast<int>(test) + 1;
  }
  return 0;
}

std::string settings_text(const ResultTable& table, const TableRow& row) {
  std::string text;
  for (const std::string& name : article_design().factors)
    text += (text.empty() ? "" : ", ") + name + " " + parameter_at(table, row, name);
  return text;
}

/// What else the article keeps fixed must be as it is there, where the table says it.
Result<void> check_fixed(const ResultTable& table) {
  for (const auto& [name, value] : article_results().fixed) {
    const auto ours = table.fixed.find(name);
    if (ours != table.fixed.end() && !same_level(ours->second, value)) {
      return Error{Code::kFailedPrecondition, "experiment has " + name + " " + ours->second + " (the article has " + value +
                                                  ") compare a study with the article's value"};
    }
    const bool varies = std::ranges::any_of(table.factors, [&](const TableFactor& factor) { return factor.name == name; });
    if (varies)
      return Error{Code::kFailedPrecondition, "experiment varies " + name + " (the article keeps " + value +
                                                  ") compare a study with the article's value"};
  }
  if (const auto damping = table.fixed.find("damping_unit"); damping != table.fixed.end() && damping->second != "absolute") {
    return Error{Code::kFailedPrecondition,
                 "experiment has damping_unit " + damping->second +
                     " (the article's eta is in N s/m) compare a study with damping_unit absolute"};
  }
  return {};
}

/// Point of ours for each of the article's tests.
Result<std::map<int, int>> match_points(const ResultTable& table) {
  for (const std::string& name : article_design().factors) {
    const bool known = table.fixed.contains(name) ||
                       std::ranges::any_of(table.factors, [&](const TableFactor& factor) { return factor.name == name; });
    if (!known)
      return Error{Code::kFailedPrecondition, "experiment does not say " + name +
                                                  " (the article's design varies it) run client/examples/article-l32.yaml"};
  }
  std::map<int, int> point_of_test;
  for (const TableRow& row : table.rows) {
    const int test = test_of(table, row);
    if (test == 0) {
      return Error{Code::kFailedPrecondition, "point " + std::to_string(row.point) + " is none of the article's 32 tests (" +
                                                  settings_text(table, row) + ") run client/examples/article-l32.yaml"};
    }
    const auto [entry, added] = point_of_test.emplace(test, row.point);
    if (!added && entry->second != row.point) {
      return Error{Code::kFailedPrecondition, "points " + std::to_string(entry->second) + " and " +
                                                  std::to_string(row.point) + " are both the article's test " +
                                                  std::to_string(test) + " (one is expected) remove one"};
    }
  }
  return point_of_test;
}

/// Mean and its standard error over the seeds of one point.
void fill_ours(const ResultTable& table, const TableResponse& response, int point, CompareCell& cell) {
  ResultTable one{.experiment = {}, .array = {}, .factors = {}, .fixed = {}, .responses = {}, .rows = {}};
  for (const TableRow& row : table.rows) {
    if (row.point == point) one.rows.push_back(row);
  }
  const PointMeans means = point_means(one, response);
  if (means.points.empty()) {
    cell.missing = means.missing.empty() ? "no value" : means.missing.front();
    return;
  }
  cell.ours = means.points.front().value;
  if (means.seed_standard_deviation)
    cell.ours_standard_error = *means.seed_standard_deviation / std::sqrt(means.points.front().seeds);
}

void summarise(CompareResponse& compare) {
  double n = 0, sum_x = 0, sum_y = 0, error = 0, relative = 0;
  for (const CompareCell& cell : compare.cells) {
    if (!cell.ours) continue;
    n += 1;
    sum_x += cell.article;
    sum_y += *cell.ours;
    error += *cell.ours - cell.article;
    relative += std::abs(*cell.ours - cell.article) / std::abs(cell.article);
  }
  compare.tests_compared = static_cast<int>(n);
  if (n == 0) return;
  compare.mean_error = error / n;
  compare.mean_absolute_relative_error = relative / n;
  double xx = 0, yy = 0, xy = 0;
  for (const CompareCell& cell : compare.cells) {
    if (!cell.ours) continue;
    const double dx = cell.article - sum_x / n, dy = *cell.ours - sum_y / n;
    xx += dx * dx;
    yy += dy * dy;
    xy += dx * dy;
  }
  if (xx > 0 && yy > 0) compare.correlation = xy / std::sqrt(xx * yy);
}

std::vector<std::string> leading_two(const ResultTable& table, const std::string& response) {
  const auto analysis = analyse_range(table, response);
  if (!analysis.ok()) return {};
  std::vector<std::string> names;
  for (int rank = 1; rank <= 2; ++rank) {
    for (const FactorAnalysis& factor : analysis->factors) {
      if (factor.rank == rank) names.push_back(factor.name);
    }
  }
  return names;
}

}  // namespace

Result<ArticleComparison> compare_article(const ResultTable& table) {
  if (const auto fixed = check_fixed(table); !fixed.ok()) return fixed.error();
  const auto points = match_points(table);
  if (!points.ok()) return points.error();
  const ResultTable article = article_results();
  ArticleComparison comparison;
  for (const TableResponse& response : article.responses) {
    const bool measured =
        std::ranges::any_of(table.responses, [&](const TableResponse& ours) { return ours.id == response.id; });
    if (!measured) {
      comparison.notes.push_back(response.id + " was not measured in this experiment");
      continue;
    }
    CompareResponse compare;
    compare.response = response.id;
    const PointMeans theirs = point_means(article, response);
    compare.unit = theirs.unit;
    for (const PointMean& test : theirs.points) {
      CompareCell cell{.test = test.point, .article = test.value, .ours = {}, .ours_standard_error = {}, .missing = {}};
      const auto point = points->find(test.point);
      if (point == points->end())
        cell.missing = "not in this experiment";
      else
        fill_ours(table, response, point->second, cell);
      compare.cells.push_back(std::move(cell));
    }
    summarise(compare);
    compare.leading_factors_article = leading_two(article, response.id);
    compare.leading_factors_ours = leading_two(table, response.id);
    comparison.responses.push_back(std::move(compare));
  }
  if (const std::size_t tests = points->size(); tests < article.rows.size()) {
    comparison.notes.push_back("the experiment holds " + std::to_string(tests) + " of the article's 32 tests");
  }
  comparison.notes.emplace_back(
      "sigma1 is compared for completeness: the article's values contradict Mohr-Coulomb in 26 of 32 tests and are no "
      "target");
  return comparison;
}

}  // namespace regolab::analysis
