/// What a specimen of another number of particles measures otherwise: of many, a smaller share touches the lid and the floor.
#pragma once
#include "scheduler/gap/bank.h"
#include "scheduler/gap/shared_gp.h"

namespace regolab::gap {

/// Number of particles that most rows of a bank have; 0 where it does not say.
double usual_size(const Bank& bank);
/// Rows of that size alone.
Bank of_size(const Bank& bank, double particles);

/// Shifts in proportion to 1 - n0 / n, of each feature alone: on one base, n particles stand n / n0 times as high.
class FiniteSize {
 public:
  FiniteSize() = default;
  /// residual: what runs of other sizes gave, less what is foretold at the usual size n0; foretold: its variance, seeds and emulator
  /// together. Both [n][p], NaN where a run has none. particles: [n]. A feature of fewer than 8 runs has no shift.
  FiniteSize(double usual, const Eigen::VectorXd& particles, const Eigen::MatrixXd& residual, const Eigen::MatrixXd& foretold);

  /// Of specimens of that many particles, less the usual size's. [p][1]; no rows where no run was of another size.
  Predicted at(double particles) const;

 private:
  double usual_ = 0;
  Eigen::VectorXd slope_, slope_variance_, spread_;  // [p] per unit of 1 - n0 / n; variance from material to material
};

}  // namespace regolab::gap
