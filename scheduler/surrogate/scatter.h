/// How runs of one material scatter, which differs from material to material: rough or long clusters scatter more than smooth ones.
#pragma once
#include <Eigen/Dense>
#include <vector>

namespace regolab::surrogate {

/// The variance of one run, as a factor on that of the average material: log-linear in the inputs.
struct Scatter {
  std::vector<double> slope;   ///< [n_inputs], empty: the same everywhere
  std::vector<double> centre;  ///< [n_inputs] the average material
  /// REQUIRES: as many inputs as slopes, unless there are none.
  double factor(const Eigen::VectorXd& scaled) const;
};

/// What repeated runs of one material showed.
struct Repeats {
  Eigen::VectorXd scaled;  ///< [n_inputs]
  double variance = 0;     ///< of one run of the smallest specimen
  double freedom = 0;      ///< degrees of freedom behind it
};

/// Slopes of largest posterior probability; variances are gamma distributed, slopes normal around 0, so few repeats say "the same".
Scatter fit_scatter(const std::vector<Repeats>& repeats);

}  // namespace regolab::surrogate
