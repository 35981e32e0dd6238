/// Gaussian process regression of many outputs over the same inputs with one kernel: what costs is done once for all of them
/// [Rasmussen and Williams 2006, ch. 2, 5].
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "scheduler/gap/gp_block.h"

namespace regolab::gap {

/// Runs. A row may stand for several of them (or be known worse than the others): `weight` runs of unit noise.
struct Sample {
  Eigen::MatrixXd x;       ///< [n][n_inputs], scaled to [0, 1]
  Eigen::MatrixXd y;       ///< [n][n_outputs]
  Eigen::VectorXd weight;  ///< [n]
};

/// Inputs that share a length (the one-hot columns of a choice) have one number.
using Groups = std::vector<int>;  // [n_inputs] ascending from 0

/// A constant, a weak linear trend and a Matern 5/2 part, all in units of an amplitude of each output's own.
struct Kernel {
  Groups group;
  std::vector<double> log_length;  ///< [n_groups]
  double log_trend = -2;           ///< variance of each slope
  std::vector<double> log_noise;   ///< [n_outputs] variance of one run, in units of the smooth part's
};

/// Means and variances of a batch of points. [n_outputs][n_points]
struct Predicted {
  Eigen::MatrixXd mean;
  Eigen::MatrixXd variance;  ///< of the mean itself
};

class SharedGp {
 public:
  /// REQUIRES: 2 rows or more, finite numbers, a log_noise for each output.
  SharedGp(Sample sample, Kernel kernel);

  /// x: [n_points][n_inputs].
  Predicted predict(const Eigen::MatrixXd& x) const;
  /// Each row predicted without itself, hyperparameters kept. As `predict`, [n_outputs][n].
  Predicted leave_one_out() const;
  /// [n_outputs] variance that one run of unit weight adds.
  const Eigen::VectorXd& noise() const { return noise_; }
  const Kernel& kernel() const { return kernel_; }
  const Sample& sample() const { return sample_; }

 private:
  void predict_block(const Eigen::MatrixXd& all, Eigen::Index first, Predicted& out) const;

  Sample sample_;
  Kernel kernel_;
  Eigen::VectorXd centre_, scale_;  // [n_outputs] of y
  Eigen::VectorXd amplitude_;       // [n_outputs] variance of the smooth part, of scaled outputs
  Eigen::VectorXd noise_;
  Eigen::MatrixXd vectors_;         // [n][n] of W^1/2 K W^1/2, times W^1/2
  Eigen::VectorXd values_;          // [n] ascending
  Eigen::MatrixXd alpha_;           // [n][n_outputs]
  Rows run_, slope_;                // [n][n_inputs] over lengths; [n_inputs][n] from the middle
  Rows alpha_rows_, vector_rows_;   // padded
  Rows told_;                       // [n][n_outputs] what each direction tells: 1 / (value + noise)
};

/// The kernel of largest posterior probability, from fixed starts: the same sample gives the same bits.
Kernel fit_kernel(const Sample& sample, const Groups& group);

}  // namespace regolab::gap
