/// A hypothesis near one point of its parameters: what its parameters can absorb of a shift, and what is left.
#pragma once
#include "scheduler/gap/hypothesis.h"

namespace regolab::gap {

class Tangent {
 public:
  /// at: [n_parameters], inside the unit cube. One-sided where a slope would leave it.
  Tangent(const Likelihood& likelihood, const Comparison& comparison, const Eigen::VectorXd& at);

  const Eigen::VectorXd& mean() const { return mean_; }      ///< [q] predicted there
  /// In standard deviations that are independent. [q][n]
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& shift) const;
  /// Of whitened shifts: without what parameters absorb, each of which moves over its prior at most.
  Eigen::MatrixXd left(const Eigen::MatrixXd& whitened) const;

 private:
  Eigen::VectorXd mean_;
  Eigen::MatrixXd lower_, basis_, absorb_;
};

}  // namespace regolab::gap
