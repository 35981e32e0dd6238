#include "scheduler/analysis/level_means.h"

#include <algorithm>
#include <charconv>

namespace regolab::analysis {

std::vector<LevelStatistics> level_statistics(const TableFactor& factor, std::size_t index, const PointMeans& means,
                                              const Effect& effect, const AdditiveModel& model) {
  std::vector<LevelStatistics> levels;
  for (const std::string& label : factor.levels) levels.push_back({.label = label, .half_width_95 = {}});
  for (const PointMean& point : means.points) {
    LevelStatistics& level = levels[static_cast<std::size_t>(point.level[index])];
    ++level.runs;
    level.sum += point.value;
  }
  const double residual = model.residual_standard_deviation();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].runs == 0) continue;
    levels[i].mean = effect.mean[i];
    if (residual > 0 && effect.mean_scale[i] > 0) {
      levels[i].half_width_95 = t_95(model.error_degrees_of_freedom()) * residual * effect.mean_scale[i];
    }
  }
  return levels;
}

void name_extremes(FactorAnalysis& analysis) {
  const LevelStatistics* high = nullptr;
  const LevelStatistics* low = nullptr;
  for (const LevelStatistics& level : analysis.levels) {
    if (level.runs == 0) continue;
    if (high == nullptr || level.mean > high->mean) high = &level;
    if (low == nullptr || level.mean < low->mean) low = &level;
  }
  if (high == nullptr) return;
  analysis.highest_level = high->label;
  analysis.lowest_level = low->label;
}

double mean_value(const PointMeans& means) {
  double sum = 0;
  for (const PointMean& point : means.points) sum += point.value;
  return sum / static_cast<double>(means.points.size());
}

void add_response_notes(const PointMeans& means, const AdditiveModel& model, std::vector<std::string>& notes) {
  if (means.most_seeds > 1) {
    const std::string seeds = means.fewest_seeds == means.most_seeds
                                  ? std::to_string(means.most_seeds)
                                  : std::to_string(means.fewest_seeds) + " to " + std::to_string(means.most_seeds);
    notes.push_back("each point is the mean over " + seeds + " seeds; K, k, R and F are of these means");
  }
  if (const auto used = static_cast<int>(means.points.size()); used < means.points_in_design) {
    notes.push_back(std::to_string(means.points_in_design - used) + " of " + std::to_string(means.points_in_design) +
                    " points have no value: K sums the rest, k and R are of the additive model fitted to the rest");
  }
  if (model.error_degrees_of_freedom() <= 0) {
    notes.push_back("no error degree of freedom: no F, no half widths, no leave-one-run-out");
  } else if (model.residual_sum_of_squares() <= 0) {
    notes.push_back("the additive model fits exactly: no residual, so no F and no half widths");
  }
}

void add_factor_notes(const FactorAnalysis& analysis, const Effect& effect, std::vector<std::string>& notes) {
  for (const LevelStatistics& level : analysis.levels) {
    if (level.runs == 0) notes.push_back(analysis.name + " = " + level.label + " has no run with a value; it is left out");
  }
  if (!effect.estimable) {
    notes.push_back(analysis.name +
                    " cannot be told from other factors by the runs there are: its k and R are plain level means");
  }
}

std::string short_number(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3);
  return {buffer, end.ptr};
}

}  // namespace regolab::analysis
