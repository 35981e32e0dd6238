#include "scheduler/surrogate/levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace regolab::surrogate {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kDampingDown = 0.1;
constexpr double kDampingUp = 10;
constexpr double kLargestDamping = 1e12;  // beyond, no direction goes down
constexpr double kSmallestDamping = 1e-15;
constexpr double kSettled = 1e-8;         // relative change of the objective that counts as none
constexpr double kPenaltySettled = 1e-3;  // the same for the penalty
constexpr double kSmallestPenalty = 1e-10;
constexpr double kLargestPenalty = 1e6;
constexpr int kSettledSteps = 3;

/// One fit under way.
class Descent {
 public:
  Descent(const LeastSquares& problem, Eigen::VectorXd w, const FitOptions& options)
      : problem_(problem), options_(options), w_(std::move(w)), penalty_(options.penalty) {
    mask_ = problem.penalised.size() > 0 ? problem.penalised : Eigen::VectorXd::Zero(w_.size());
    residual_ = problem_.residual(w_);
  }

  Fit run() {
    best_ = w_;
    best_watched_ = options_.watched ? options_.watched(w_) : 0;
    Fit fit;
    int settled = 0;
    int since_best = 0;
    while (fit.steps < options_.max_steps) {
      linearise();
      const double before = objective(w_, residual_);
      if (!step(before)) {
        fit.end = FitEnd::kNoDescent;
        break;
      }
      ++fit.steps;
      const double after = objective(w_, residual_);
      const bool penalty_settled = update_penalty();
      since_best = watch() ? 0 : since_best + 1;
      if (options_.watched && since_best >= options_.patience) {
        fit.end = FitEnd::kEarlyStopped;
        break;
      }
      settled = before - after <= kSettled * before && penalty_settled ? settled + 1 : 0;
      if (settled >= kSettledSteps) {
        fit.end = FitEnd::kConverged;
        break;
      }
    }
    return finish(std::move(fit));
  }

 private:
  double objective(const Eigen::VectorXd& w, const Eigen::VectorXd& residual) const {
    return residual.squaredNorm() + penalty_ * mask_.dot(w.cwiseAbs2());
  }

  void linearise() {
    const Eigen::MatrixXd jacobian = problem_.jacobian(w_);
    gauss_newton_.noalias() = jacobian.transpose() * jacobian;
    gradient_.noalias() = jacobian.transpose() * residual_;
  }

  /// One step downhill; false when none is found. The damping adds to the diagonal (Levenberg).
  bool step(double before) {
    for (; damping_ <= kLargestDamping; damping_ *= kDampingUp) {
      Eigen::MatrixXd matrix = gauss_newton_;
      matrix.diagonal() += penalty_ * mask_;
      matrix.diagonal().array() += damping_;
      const Eigen::VectorXd next = w_ - matrix.ldlt().solve(gradient_ + penalty_ * mask_.cwiseProduct(w_));
      if (!next.allFinite()) continue;
      Eigen::VectorXd residual = problem_.residual(next);
      if (!residual.allFinite() || objective(next, residual) > before) continue;
      w_ = next;
      residual_ = std::move(residual);
      damping_ = std::max(damping_ * kDampingDown, kSmallestDamping);
      return true;
    }
    return false;
  }

  /// gamma = sum over the penalised weights of 1 - penalty * (H^-1)_ii, plus the free ones.
  double weights_in_use() const {
    Eigen::MatrixXd matrix = gauss_newton_;
    matrix.diagonal() += penalty_ * mask_;
    matrix.diagonal().array() += kSmallestDamping;
    const Eigen::MatrixXd inverse = matrix.ldlt().solve(Eigen::MatrixXd::Identity(w_.size(), w_.size()));
    return static_cast<double>(w_.size()) - penalty_ * mask_.dot(inverse.diagonal());
  }

  /// The penalty at which the data are most likely, given the weights as they are now. True when it hardly moved.
  bool update_penalty() {
    if (options_.mode == Penalty::kFixed) return true;
    const double in_use = weights_in_use();
    const double free_weights = static_cast<double>(w_.size()) - mask_.sum();
    const double observations = options_.independent > 0 ? options_.independent : static_cast<double>(residual_.size());
    const double left = std::max(observations - in_use, 1.0);
    const double size = std::max(mask_.dot(w_.cwiseAbs2()), kSmallestPenalty);
    const double next = std::max(in_use - free_weights, 0.0) * residual_.squaredNorm() / (size * left);
    const double old = penalty_;
    penalty_ = std::clamp(next, kSmallestPenalty, kLargestPenalty);
    return std::abs(penalty_ - old) <= kPenaltySettled * old;
  }

  /// True when the error on the rows held back is the smallest so far.
  bool watch() {
    if (!options_.watched) {
      best_ = w_;
      return true;
    }
    const double error = options_.watched(w_);
    if (!(error < best_watched_)) return false;
    best_watched_ = error;
    best_ = w_;
    return true;
  }

  Fit finish(Fit fit) {
    w_ = best_;
    residual_ = problem_.residual(w_);
    linearise();
    fit.w = w_;
    fit.sum_of_squares = residual_.squaredNorm();
    fit.penalty = penalty_;
    fit.weights_in_use = weights_in_use();
    fit.watched = best_watched_;
    return fit;
  }

  const LeastSquares& problem_;
  const FitOptions& options_;
  Eigen::VectorXd w_;             // [weights]
  Eigen::VectorXd residual_;      // [n] at w_
  Eigen::VectorXd mask_;          // [weights]
  Eigen::MatrixXd gauss_newton_;  // [weights][weights] J'J
  Eigen::VectorXd gradient_;      // [weights] J'r
  double penalty_ = 0;
  double damping_ = kFirstDamping;
  Eigen::VectorXd best_;
  double best_watched_ = 0;
};

}  // namespace

Fit fit_least_squares(const LeastSquares& problem, Eigen::VectorXd w, const FitOptions& options) {
  return Descent(problem, std::move(w), options).run();
}

}  // namespace regolab::surrogate
