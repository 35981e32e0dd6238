/// The parts of a range analysis that describe levels, and the notes that go with it.
#pragma once
#include <string>
#include <vector>

#include "scheduler/analysis/additive_model.h"
#include "scheduler/analysis/point_means.h"
#include "scheduler/analysis/range.h"

namespace regolab::analysis {

/// K, k and the 95 % half width of each level of factor number `index`.
std::vector<LevelStatistics> level_statistics(const TableFactor& factor, std::size_t index, const PointMeans& means,
                                              const Effect& effect, const AdditiveModel& model);

/// Sets highest_level and lowest_level, among levels that have runs.
void name_extremes(FactorAnalysis& analysis);

/// Mean over the points that have a value.
double mean_value(const PointMeans& means);

/// What was averaged, what is missing, and what the model could not say.
void add_response_notes(const PointMeans& means, const AdditiveModel& model, std::vector<std::string>& notes);
void add_factor_notes(const FactorAnalysis& analysis, const Effect& effect, std::vector<std::string>& notes);

/// At most 3 significant digits: "0.0512", "21.5".
std::string short_number(double value);

}  // namespace regolab::analysis
