/// How much one material's specimens scatter beside another's: the variance of sigma1 of rough clusters is many times that of smooth spheres.
#pragma once
#include <Eigen/Dense>

namespace regolab::gap {

/// A variance in units of the mean over materials, log-linear in their inputs. 1 everywhere where repeats do not foretell it.
class NoiseScale {
 public:
  NoiseScale() = default;
  /// x: [n][n_inputs]; ratio: [n] variance between repeats of each material over the mean variance, NaN where there are none.
  NoiseScale(const Eigen::MatrixXd& x, const Eigen::VectorXd& ratio);

  Eigen::VectorXd at(const Eigen::MatrixXd& x) const;  ///< [n_points]

 private:
  Eigen::VectorXd slope_;
  double level_ = 0;  ///< of the logarithm
};

}  // namespace regolab::gap
