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
  Eigen::VectorXd y;                  // [q] as specimens of the bank's size would have measured
  Eigen::VectorXd size_shift;         // [q] what was measured less that
  Eigen::VectorXd variance;           // [q] of the measured mean: its own error and seeds
  Eigen::MatrixXd correlation;        // [q][q] of those
  Eigen::MatrixXd error_correlation;  // [q][q] of the emulator's errors without effects
  Eigen::VectorXd ours;               // [q] of that, what was pooled from our own runs' scatter: materials scatter more or less
  Eigen::VectorXd share;              // [q] of one run's variance in the measured mean: few large specimens scatter as many small ones
  Eigen::VectorXd between_alone;      // [q] of the variance, what codes differ by in this feature alone: repeats do not lessen it
  Eigen::MatrixXd between_codes;      // [q][q] what codes differ by in features that differ together, beside the variance
  Eigen::VectorXd by_step;            // [q] what features shift by together where a time step was another
  Eigen::VectorXd size_variance;      // [q] of what another number of particles shifts: it goes together as the emulator's errors do
  bool same_code = false;             // measured by this very code

  Eigen::Index size() const { return y.size(); }
  /// Covariance of the emulator's errors, where it says `emulator_variance` of its means without effects, and of what time steps do. [q][q]
  Eigen::MatrixXd base_error(const Eigen::VectorXd& emulator_variance) const;
  /// Of measured less predicted, where the emulator errs by `error`; `difference` times what codes differ by, where our own runs scatter
  /// `scale` times as much as the mean material's (empty: as much). [q][q]
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& error, double difference = 1, const Eigen::VectorXd& scale = {}) const;
  Eigen::MatrixXd covariance(const Eigen::VectorXd&, double = 1, const Eigen::VectorXd& = {}) const = delete;  ///< a column is no covariance
  /// Without what codes differ by.
  void differ_by_nothing();
  /// The same without some of its features (or with only some).
  Comparison subset(const std::vector<Eigen::Index>& kept) const;
};

/// Features that both have. A standard error from few repeats is itself uncertain: it is pooled with what our own seeds scatter by
/// (scaled to the measured specimen's size), which counts as `kPriorFreedom` degrees of freedom.
inline constexpr double kPriorFreedom = 6;
Comparison compare(const Emulator& emulator, const ObservationSet& set);
/// Of features given one by one; those that the emulator lacks are left out. size_ratio: of one run's scatter in a specimen of the
/// measured size, at most 1.
Comparison compare(const Emulator& emulator, const std::vector<Feature>& features, double size_ratio);
double size_ratio_of(const ObservationSet& set);

/// Log density of a multivariate Student t.
double student_t_log_density(const Eigen::VectorXd& off, const Eigen::MatrixXd& covariance);
inline constexpr double kFreedom = 15;  ///< of the t: one wild feature must not decide

}  // namespace regolab::gap
