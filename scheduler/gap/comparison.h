/// Measured features beside the emulator's: values, what is known of their errors, and how errors go together.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/emulator.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

struct Comparison {
  std::vector<Eigen::Index> feature;  // [q] of the emulator
  std::vector<Feature> measured;      // [q]
  Eigen::VectorXd y;                  // [q]
  Eigen::VectorXd variance;           // [q] of the measured mean: its own error, seeds, and what codes differ by
  Eigen::MatrixXd correlation;        // [q][q]

  Eigen::Index size() const { return y.size(); }
  /// The same without some of its features (or with only some).
  Comparison subset(const std::vector<Eigen::Index>& kept) const;
};

/// Features that both have. A standard error from few repeats is itself uncertain: it is pooled with what our own seeds scatter by
/// (scaled to the measured specimen's size), which counts as `kPriorFreedom` degrees of freedom.
inline constexpr double kPriorFreedom = 6;
Comparison compare(const Emulator& emulator, const ObservationSet& set);

/// Log density of a multivariate Student t whose covariance is S C S: S diagonal (`sd`), C of the comparison.
struct StudentT {
  explicit StudentT(const Eigen::MatrixXd& correlation);
  double log_density(const Eigen::VectorXd& off, const Eigen::VectorXd& sd) const;
  /// Squared Mahalanobis distance.
  double distance2(const Eigen::VectorXd& off, const Eigen::VectorXd& sd) const;

 private:
  Eigen::MatrixXd inverse_;  ///< of C
  double log_det_;
};
/// Of a covariance given whole.
double student_t_log_density(const Eigen::VectorXd& off, const Eigen::MatrixXd& covariance);
inline constexpr double kFreedom = 8;  ///< of the t: one wild feature must not decide

}  // namespace regolab::gap
