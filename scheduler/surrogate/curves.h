/// Stress-strain curves as a surrogate sees them.
#pragma once
#include <functional>

#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

/// "sigma1_at_sigma3_2.5kPa" -> 2500 Pa; empty when the id does not begin so or goes on after the unit.
std::optional<double> confining_stress_of(const std::string& id, std::string_view prefix);
std::string kilopascals(double pascal);  ///< 2500 -> "2.5kPa"

/// Where a stress lies among ascending ones: (1 - share) of number `low`, share of the next, over the logarithm. Empty: outside.
struct Between {
  std::size_t low = 0;
  double share = 0;
};
std::optional<Between> between(const std::vector<double>& sigma3, double at);

/// From the dataset's curve samples; empty when too few rows hold whole curves. `fit` gives the process of one score.
std::optional<CurveModel> curve_model(const Dataset& data, const Scatter& scatter, const std::function<GaussianProcess(Observations, std::size_t k)>& fit);

/// Logarithm of sigma1 on the strain grid, with standard deviations; empty outside the confining stresses of the data.
struct CurveValue {
  double mean, of_mean, of_run;
};
std::vector<CurveValue> curves_at(const CurveModel& model, const Inputs& inputs, double sigma3);

}  // namespace regolab::surrogate
