/// Range analysis [article Sec. 3.1.1, Eq. 2] with what it needs to be believed: ANOVA, leave-one-run-out, seed error bars.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::analysis {

/// A run is one design point: the mean over its seeds. Every number is in the response's door unit (vocab/units.h).
struct LevelStatistics {
  std::string label;
  int runs = 0;
  double sum = 0;   ///< K: of the runs there are
  double mean = 0;  ///< k: sum / runs when the table is complete; else the additive model's mean at this level
  std::optional<double> half_width_95;  ///< of the mean, from the error degrees of freedom
};

struct FactorAnalysis {
  std::string name;
  std::string unit;
  std::vector<LevelStatistics> levels;         // [n_levels], design order
  double range = 0;                            ///< R = max k - min k [article Eq. 2]
  std::optional<double> range_standard_error;  ///< from replicate seeds
  int rank = 0;                                ///< 1 = largest R
  std::string highest_level;
  std::string lowest_level;
  double sum_of_squares = 0;  ///< what the model loses without this factor (type III; the classical one when balanced)
  int degrees_of_freedom = 0;
  std::optional<double> f;
  std::optional<double> p;
  double leave_one_out_range_min = 0;  ///< smallest and largest R of the additive model refitted without one run
  double leave_one_out_range_max = 0;
  int leaning_on_point = 0;  ///< the run whose removal changes R most; 0 = no run can be spared
  bool fragile = false;      ///< significant, or twice the others, only with that run
  std::string fragile_why;
};

struct ResponseAnalysis {
  std::string response;
  std::string unit;  ///< door unit
  int runs_used = 0;
  std::vector<std::string> missing;  ///< "point 7 seed 1: not settled (...)"
  double mean = 0;
  double residual_standard_deviation = 0;  ///< of the additive model; 0 when no degree of freedom is left
  int error_degrees_of_freedom = 0;
  std::optional<double> seed_standard_deviation;  ///< pooled over points with two seeds or more
  std::vector<FactorAnalysis> factors;
  std::vector<std::string> notes;
};

/// Errors: kNotFound (no such response; the text names those there are), kFailedPrecondition (fewer than two runs measured, or
/// points that scatter: table_shape.h),
/// kDataLoss (rows that do not fit the factors).
Result<ResponseAnalysis> analyse_range(const ResultTable& table, const std::string& response);

/// `response` empty: the primary ones that have results; "all": every one that has; else that one.
Result<std::vector<ResponseAnalysis>> analyse_ranges(const ResultTable& table, const std::string& response);

/// contacts_per_particle, bulk_density, void_ratio, repose_angle, sigma1_at_sigma3_*: the article's own responses.
bool is_primary(std::string_view response);

}  // namespace regolab::analysis
