/// What a DEM bundle would measure, from micro-parameters and strengths of effects, with its own error: m(theta, u) = m_0(theta) + sum of
/// Delta_k(theta, u_k), and Delta_k(theta, 0) = 0 by construction.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "scheduler/gap/finite_size.h"
#include "scheduler/gap/noise_scale.h"
#include "scheduler/gap/repeats.h"
#include "scheduler/gap/space.h"
#include "vocab/effects.h"
#include "vocab/result.h"

namespace regolab::gap {

/// A hypothesis about one effect: where its strength may lie, and how it grows.
struct Cause {
  const EffectInfo* effect = nullptr;
  double strength(double u) const;  ///< at share u of its prior, u in [0, 1]
  double share(double strength) const;
  /// What shifts are nearly proportional to: 0 without the effect, about 1 at the end of its prior; signed where strengths are.
  double growth(double strength) const;
};

/// The strengths of one cause for a batch. strength: [n_points]
struct Use {
  std::size_t cause = 0;
  Eigen::VectorXd strength;
};

class Emulator {
 public:
  /// Fits every process. `kernels`: as `kernels()` gave them, to spare the fit. kFailedPrecondition: too few runs without effects.
  static Result<Emulator> from(const Bank& bank, const std::vector<Kernel>& kernels = {});

  const Space& space() const { return space_; }
  const std::vector<FeatureInfo>& features() const { return features_; }  // [p]
  const std::vector<Cause>& causes() const { return causes_; }
  int feature(const std::string& id) const;  ///< -1: none

  /// values: [n_axes][n_points], SI. [p][n_points], variance of the mean.
  Predicted predict(const Eigen::MatrixXd& values, std::span<const Use> uses = {}) const;
  /// What one effect adds to that. [p][n_points]
  Predicted shift(const Eigen::MatrixXd& values, const Use& use) const;
  const Eigen::VectorXd& noise() const { return noise_; }                ///< [p] variance of one run, of repeats, mean over materials
  Eigen::MatrixXd noise_scale(const Eigen::MatrixXd& values) const;     ///< of that, of these materials; `values` as in `predict`. [p][n_points]
  /// [p] variance that one run with an effect at full growth has beyond that, and in proportion to growth^2 below: sticky or rubbed
  /// grains scatter more than plain ones.
  const Eigen::VectorXd& scatter(std::size_t cause) const { return effects_[cause].scatter; }
  const Eigen::MatrixXd& correlation() const { return correlation_; }   ///< [p][p] of what seeds do
  const Eigen::MatrixXd& error_correlation() const { return error_correlation_; }  ///< [p][p] of what the emulator gets wrong itself
  const Eigen::MatrixXd& error_correlation(std::size_t cause) const { return effects_[cause].error_correlation; }  ///< of a cause's shifts
  /// What a specimen of that many particles measures, less one of the bank's usual size. [p][1]; no rows where the bank has one size alone.
  Predicted of_particles(double particles) const { return size_.at(particles); }
  std::vector<Kernel> kernels() const;  ///< in an order of their own, for `from`

 private:
  struct Family {
    std::vector<Eigen::Index> members;  ///< features
    std::shared_ptr<const SharedGp> gp;
    NoiseScale scale;  ///< of base families
  };
  struct Effect {
    std::vector<Family> families;
    Eigen::VectorXd scatter;  ///< [p] at full growth
    Eigen::MatrixXd error_correlation;  ///< [p][p]
  };

  Space space_;
  std::vector<FeatureInfo> features_;
  std::vector<Cause> causes_;
  std::vector<Family> base_;
  std::vector<Effect> effects_;  ///< of causes_
  Eigen::VectorXd noise_;
  Eigen::VectorXd misfit_;       ///< [p] variance that the base processes leave beyond the seeds' own
  Eigen::MatrixXd correlation_, error_correlation_;
  FiniteSize size_;

  using Process = std::function<std::shared_ptr<const SharedGp>(Sample, const Groups&)>;  ///< fits one, or takes its kernel
  void learn_base(const Repeats& base, const Process& process);
  Effect learn_effect(const Bank& bank, const std::vector<const BankRow*>& rows, const Cause& cause, const Process& process) const;
  void compare_sizes(const Bank& bank, double usual);
  void judge(const Eigen::MatrixXd& residual, const Eigen::MatrixXd& foretold, double runs);
};

}  // namespace regolab::gap
