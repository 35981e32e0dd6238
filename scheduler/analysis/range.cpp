#include "scheduler/analysis/range.h"

#include <algorithm>
#include <cmath>

#include "scheduler/analysis/additive_model.h"
#include "scheduler/analysis/level_means.h"
#include "scheduler/analysis/point_means.h"
#include "scheduler/analysis/table_shape.h"

namespace regolab::analysis {
namespace {

constexpr double kSignificant = 0.05;
constexpr double kTie = 1e-9;  // symmetric designs have runs of equal weight: the first is named, whatever the rounding

/// The article's rule: an effect matters when its range is at least twice that of the others [article Sec. 3.1.1]. "The
/// others" are read as their lower quartile, the background every factor has.
bool stands_out(std::size_t factor, const std::vector<double>& ranges) {
  std::vector<double> others = ranges;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(factor));
  if (others.empty()) return false;
  std::ranges::sort(others);
  const std::size_t half = others.size() / 2;  // lower quartile = median of the lower half
  const double background = half == 0       ? others[0]
                            : half % 2 == 1 ? others[half / 2]
                                            : 0.5 * (others[half / 2 - 1] + others[half / 2]);
  return ranges[factor] >= 2 * background && ranges[factor] > 0;
}

std::vector<int> level_counts(const ResultTable& table) {
  std::vector<int> levels;
  for (const TableFactor& factor : table.factors) levels.push_back(static_cast<int>(factor.levels.size()));
  return levels;
}

AdditiveModel fit(const ResultTable& table, const PointMeans& means) {
  std::vector<std::vector<int>> rows;
  std::vector<double> y;
  for (const PointMean& point : means.points) {
    rows.push_back(point.level);
    y.push_back(point.value);
  }
  return {level_counts(table), std::move(rows), std::move(y)};
}

/// Leave-one-run-out: the smallest and largest range, the run it leans on, and whether the effect falls with it.
void leave_one_out(const AdditiveModel& model, const PointMeans& means, std::size_t factor,
                   const std::vector<double>& ranges, FactorAnalysis& analysis) {
  analysis.leave_one_out_range_min = analysis.leave_one_out_range_max = analysis.range;
  std::optional<std::size_t> leaning;
  AdditiveModel::Without changed;
  for (std::size_t run = 0; run < means.points.size(); ++run) {
    const auto without = model.without(run, factor);
    if (!without) continue;
    analysis.leave_one_out_range_min = std::min(analysis.leave_one_out_range_min, without->range);
    analysis.leave_one_out_range_max = std::max(analysis.leave_one_out_range_max, without->range);
    const double most = leaning ? std::abs(changed.range - analysis.range) : -1;
    if (std::abs(without->range - analysis.range) <= most * (1 + kTie)) continue;
    leaning = run;
    changed = *without;
  }
  if (!leaning) return;
  analysis.leaning_on_point = means.points[*leaning].point;
  std::vector<double> ranges_without = ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (const auto without = model.without(*leaning, i)) ranges_without[i] = without->range;
  }
  const std::string start = "without point " + std::to_string(analysis.leaning_on_point) + " R goes from " +
                            short_number(analysis.range) + " to " + short_number(changed.range);
  if (stands_out(factor, ranges) && !stands_out(factor, ranges_without)) {
    analysis.fragile = true;
    analysis.fragile_why = start + " and is no longer twice that of the others";
  }
  if (analysis.p && *analysis.p < kSignificant && changed.p && *changed.p >= kSignificant) {
    analysis.fragile = true;
    analysis.fragile_why += (analysis.fragile_why.empty() ? start + " and" : "; there") + std::string(" p goes from ") +
                            short_number(*analysis.p) + " to " + short_number(*changed.p);
  }
}

/// From replicate seeds: a point's mean over n seeds has variance s^2/n.
std::optional<double> range_error(const AdditiveModel& model, const PointMeans& means, std::size_t factor,
                                  const FactorAnalysis& analysis, bool estimable) {
  if (!means.seed_standard_deviation || !estimable || analysis.levels.size() < 2) return std::nullopt;
  const auto index_of = [&](const std::string& label) {
    return static_cast<int>(std::ranges::find(analysis.levels, label, &LevelStatistics::label) - analysis.levels.begin());
  };
  const std::vector<double> weight =
      model.contrast_weights(factor, index_of(analysis.highest_level), index_of(analysis.lowest_level));
  double variance = 0;
  for (std::size_t run = 0; run < weight.size(); ++run) variance += weight[run] * weight[run] / means.points[run].seeds;
  return *means.seed_standard_deviation * std::sqrt(variance);
}

FactorAnalysis analyse_factor(const ResultTable& table, const PointMeans& means, const AdditiveModel& model,
                              std::size_t index, std::vector<std::string>& notes) {
  const TableFactor& factor = table.factors[index];
  const Effect effect = model.effect(index);
  FactorAnalysis analysis;
  analysis.name = factor.name;
  analysis.unit = factor.unit;
  analysis.levels = level_statistics(factor, index, means, effect, model);
  analysis.range = effect.range;
  analysis.sum_of_squares = effect.sum_of_squares;
  analysis.degrees_of_freedom = effect.degrees_of_freedom;
  analysis.f = effect.f;
  analysis.p = effect.p;
  name_extremes(analysis);
  analysis.range_standard_error = range_error(model, means, index, analysis, effect.estimable);
  add_factor_notes(analysis, effect, notes);
  return analysis;
}

void rank_factors(std::vector<FactorAnalysis>& factors) {
  for (FactorAnalysis& factor : factors) {
    factor.rank = 1;
    for (const FactorAnalysis& other : factors)
      factor.rank += other.range > factor.range || (other.range == factor.range && &other < &factor) ? 1 : 0;
  }
}

/// Nothing can be told apart where every point has levels of its own.
Result<void> analysable(const ResultTable& table) {
  if (!well_formed(table)) {
    return Error{Code::kDataLoss,
                 "the table's rows do not fit its factors (stored levels are damaged) submit the design again"};
  }
  if (const auto why = scatters(table))
    return Error{Code::kFailedPrecondition,
                 "a range analysis needs levels that repeat (" + *why + ") train a surrogate on it"};
  return {};
}

Error no_such_response(const ResultTable& table, const std::string& response) {
  std::string known;
  for (const TableResponse& r : table.responses) known += (known.empty() ? "" : ", ") + r.id;
  return {Code::kNotFound, "no response '" + response + "' (the experiment has: " + known + ") choose one of these"};
}

bool has_results(const ResultTable& table, const std::string& response) {
  return point_means(table, {response, "1"}).points.size() >= 2;
}

}  // namespace

bool is_primary(std::string_view response) {
  return response == "contacts_per_particle" || response == "bulk_density" || response == "void_ratio" ||
         response == "repose_angle" || response.starts_with("sigma1_at_sigma3_") ||
         response.starts_with("penetration_force_0.25_0.50_plate_");
}

Result<ResponseAnalysis> analyse_range(const ResultTable& table, const std::string& response) {
  const auto found = std::ranges::find(table.responses, response, &TableResponse::id);
  if (found == table.responses.end()) return no_such_response(table, response);
  if (auto fit = analysable(table); !fit.ok()) return fit.error();
  const PointMeans means = point_means(table, *found);
  if (means.points.size() < 2) {
    return Error{Code::kFailedPrecondition, response + " is known at " + std::to_string(means.points.size()) + " of " +
                                                std::to_string(means.points_in_design) + " points (two are needed" +
                                                (means.missing.empty() ? "" : "; " + means.missing.front()) +
                                                ") wait for more results"};
  }
  const AdditiveModel model = fit(table, means);
  ResponseAnalysis analysis{.response = response,
                            .unit = means.unit,
                            .runs_used = static_cast<int>(means.points.size()),
                            .missing = means.missing,
                            .mean = mean_value(means),
                            .residual_standard_deviation = model.residual_standard_deviation(),
                            .error_degrees_of_freedom = model.error_degrees_of_freedom(),
                            .seed_standard_deviation = means.seed_standard_deviation,
                            .factors = {},
                            .notes = {}};
  add_response_notes(means, model, analysis.notes);
  std::vector<double> ranges;
  for (std::size_t i = 0; i < table.factors.size(); ++i) {
    analysis.factors.push_back(analyse_factor(table, means, model, i, analysis.notes));
    ranges.push_back(analysis.factors.back().range);
  }
  for (std::size_t i = 0; i < table.factors.size(); ++i) leave_one_out(model, means, i, ranges, analysis.factors[i]);
  rank_factors(analysis.factors);
  return analysis;
}

Result<std::vector<ResponseAnalysis>> analyse_ranges(const ResultTable& table, const std::string& response) {
  if (auto fit = analysable(table); !fit.ok()) return fit.error();
  std::vector<ResponseAnalysis> analyses;
  const bool all = response == "all";
  if (!response.empty() && !all) {
    auto one = analyse_range(table, response);
    if (!one.ok()) return one.error();
    analyses.push_back(*std::move(one));
    return analyses;
  }
  for (const TableResponse& candidate : table.responses) {
    if ((!all && !is_primary(candidate.id)) || !has_results(table, candidate.id)) continue;
    auto one = analyse_range(table, candidate.id);
    if (one.ok()) analyses.push_back(*std::move(one));
  }
  if (analyses.empty()) {
    return Error{Code::kFailedPrecondition,
                 "no response is known at two points yet (nothing to compare) wait for more results"};
  }
  return analyses;
}

}  // namespace regolab::analysis
