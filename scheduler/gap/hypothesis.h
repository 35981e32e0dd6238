/// What may be the case: the base model, one effect or a pair of them, or something that no effect of the library makes.
#pragma once
#include <optional>
#include <string>

#include "scheduler/gap/comparison.h"
#include "scheduler/gap/smc.h"

namespace regolab::gap {

/// Where the strength of an effect may lie. What the measurements at hand cannot notice is left out: a prior that reaches down to nothing
/// would make every effect look like none [Johnson and Rossell 2010, doi 10.1111/j.1467-9868.2009.00730.x].
struct StrengthRange {
  double low = 0, high = 0;  ///< [SI of the effect]
  double below = 0, above = 0;  ///< nothing between them counts
  bool logarithmic = false;

  static StrengthRange of(const Cause& cause, double least = 0);
  double at(double u) const;  ///< u in [0, 1]
};

struct Hypothesis {
  std::string name;                    ///< "none", an effect's, "a+b", "unknown"
  std::vector<std::size_t> causes;     ///< of the emulator
  bool unknown = false;
  std::vector<StrengthRange> strength; ///< of the causes; empty: their whole priors
  bool offset_read = false;            ///< a lateral stress offset shows in the measured sigma3: a gauge beside the controller's
};

/// What a batch of points foretells. [q][n_points]
struct Foretold {
  /// What an effect adds: to the means, and standard deviations of the emulator's error and of what specimens with it scatter more by.
  struct Shift {
    Eigen::MatrixXd mean, wrong, scatter;
  };
  Eigen::MatrixXd mean;
  Eigen::MatrixXd variance;    ///< of the base model's mean
  Eigen::MatrixXd scale;       ///< how much such materials scatter (NoiseScale)
  std::vector<Shift> effects;  ///< of the hypothesis
};

/// A micro-parameter that the experimenter states.
struct Stated {
  double value = 0;           ///< [SI]
  double standard_error = 0;  ///< 0: exact
};

/// A hypothesis against a comparison: parameters in the unit cube, micro-parameters first, then how much this code and the measured one
/// differ, then strengths, then the size of the unknown.
class Likelihood {
 public:
  /// Emulator and comparison must outlive it. library: covariance of what known effects shift, [q][q], of the unknown hypothesis alone.
  Likelihood(const Emulator& emulator, const Comparison& comparison, const Hypothesis& hypothesis, std::map<std::string, Stated> stated,
             const Eigen::MatrixXd& library = {});

  int parameters() const;
  Eigen::VectorXd operator()(const Eigen::MatrixXd& u) const;

  /// [n_axes][n_points] SI; strength of cause k at each point.
  Eigen::MatrixXd values(const Eigen::MatrixXd& u) const;
  Eigen::VectorXd strength(const Eigen::MatrixXd& u, std::size_t k) const;
  /// How many times the usual difference between codes there is, at one point.
  double difference(const Eigen::VectorXd& u) const;
  /// How many times the library's shifts the unknown is, at one point. REQUIRES: the hypothesis is the unknown.
  double unknown_size(const Eigen::VectorXd& u) const;
  /// Covariance of the errors of what is foretold at one of the points that `predict` was asked for: of the emulator, of another law by the
  /// same name, and of what effects scatter. [q][q]
  Eigen::MatrixXd error(const Foretold& foretold, const Eigen::MatrixXd& u, Eigen::Index point) const;
  /// Of measured less foretold there. [q][q]
  Eigen::MatrixXd covariance(const Foretold& foretold, const Eigen::MatrixXd& u, Eigen::Index point) const;
  /// The emulator's answer for the features compared.
  Foretold predict(const Eigen::MatrixXd& u) const;

 private:
  const Emulator& emulator_;
  const Comparison& comparison_;
  Hypothesis hypothesis_;
  std::map<std::string, Stated> stated_;
  std::vector<std::size_t> free_;  ///< axes that u holds
  Eigen::MatrixXd library_;
  std::vector<Eigen::MatrixXd> go_together_;  // [q][q] correlation of the errors of each cause
};

/// The largest difference between codes, in usual ones; of measurements by this very code, which emulators do not wholly foretell either.
inline constexpr double kMostDifferent = 1.5, kMostOfOneCode = 0.75;

/// Covariance of the shifts that the library's effects make over their priors, in the features compared. [q][q]
Eigen::MatrixXd library_covariance(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed);

/// What the experimenter stated of the emulator's axes: sizes, gravity, measured micro-parameters.
std::map<std::string, Stated> stated_in(const ObservationSet& set, const Space& space);

}  // namespace regolab::gap
