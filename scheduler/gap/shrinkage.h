/// How far a gap shrinks: new runs of the re-calibrated base model and of the repaired one, on measurements that neither was fitted to.
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <optional>
#include <string>

namespace regolab::gap {

/// What new runs are compared with. Runs: [q][n], a column a run, NaN where a run has no number.
struct Target {
  Eigen::VectorXd y;           // [q] measured
  Eigen::MatrixXd covariance;  // [q][q] of its errors
};

/// G^2 = mean over features of ((y - run mean)^2 - sigma^2 - s^2 / n) / sigma^2: the squared gap in units of the measurement's error, less what
/// noise alone would make of it, so that its expectation is the gap of the means. s^2: scatter of the runs, of which a feature has n.
struct SquaredGap {
  double value = 0;
  double noise_95 = 0;  ///< what it stays below in 95 of 100 cases when there is no gap
  bool seen() const { return value > noise_95; }
};
SquaredGap squared_gap(const Target& target, const Eigen::MatrixXd& runs, std::uint64_t seed);

/// S = 1 - G_repaired / G_base: 1 when the gap is gone, 0 when nothing was gained, below when it grew.
struct Shrinkage {
  SquaredGap base, repaired;
  std::optional<double> s;    ///< nothing when the base model's gap is within noise
  std::optional<double> low, high;  ///< 5 and 95 %; nothing where resampled base gaps vanish
};
/// The interval: bootstrap over runs of either model and over the measurement's errors, each resampled gap less the noise that
/// resampling itself adds.
Shrinkage shrinkage_of(const Target& target, const Eigen::MatrixXd& base, const Eigen::MatrixXd& repaired, std::uint64_t seed);

inline constexpr int kFewestRuns = 3;  ///< of a feature, for its scatter to be known at all

}  // namespace regolab::gap
