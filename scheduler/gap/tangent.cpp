#include "scheduler/gap/tangent.h"

namespace regolab::gap {
namespace {

constexpr double kStep = 0.02;       // of the unit cube
constexpr double kPriorSpread = 12;  // 1/variance of a number between 0 and 1

}  // namespace

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Tangent::Tangent(const Likelihood& likelihood, const Comparison& comparison, const VectorXd& at) {
  const auto d = at.size();
  MatrixXd u = at.replicate(1, 2 * d + 1);
  for (Index k = 0; k < d; ++k) {
    u(k, 2 * k) = std::max(0.0, at[k] - kStep);
    u(k, 2 * k + 1) = std::min(1 - 1e-9, at[k] + kStep);
  }
  const Foretold p = likelihood.predict(u);
  mean_ = p.mean.col(2 * d);
  lower_ = Eigen::LLT<MatrixXd>(likelihood.covariance(p, u, 2 * d)).matrixL();
  MatrixXd slopes(comparison.size(), d);
  for (Index k = 0; k < d; ++k) slopes.col(k) = (p.mean.col(2 * k + 1) - p.mean.col(2 * k)) / (u(k, 2 * k + 1) - u(k, 2 * k));
  basis_ = whitened(slopes);
  absorb_ = (basis_.transpose() * basis_ + kPriorSpread * MatrixXd::Identity(d, d)).ldlt().solve(basis_.transpose());
}

MatrixXd Tangent::whitened(const MatrixXd& shift) const { return lower_.triangularView<Eigen::Lower>().solve(shift); }

MatrixXd Tangent::left(const MatrixXd& whitened) const { return whitened - basis_ * (absorb_ * whitened); }

}  // namespace regolab::gap
