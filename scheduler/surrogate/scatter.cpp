#include "scheduler/surrogate/scatter.h"

#include <algorithm>
#include <cmath>

namespace regolab::surrogate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSlopeSpread = 1;   // prior, of the logarithm across the whole range of an input
constexpr double kLeast = 1e-4;      // of the mean variance: two runs may agree by chance
constexpr double kMostFactor = 8;
constexpr std::size_t kFewest = 10;  // materials with repeats

}  // namespace

double Scatter::factor(const VectorXd& scaled) const {
  double log_factor = 0;
  for (std::size_t k = 0; k < slope.size(); ++k) log_factor += slope[k] * (scaled[static_cast<Index>(k)] - centre[k]);
  return std::clamp(std::exp(log_factor), 1 / kMostFactor, kMostFactor);
}

Scatter fit_scatter(const std::vector<Repeats>& repeats) {
  if (repeats.size() < kFewest) return {};
  const auto n = static_cast<Index>(repeats.size()), d = repeats.front().scaled.size();
  MatrixXd x(n, d + 1);
  VectorXd s2(n), half_freedom(n);
  for (Index i = 0; i < n; ++i) {
    const Repeats& r = repeats[static_cast<std::size_t>(i)];
    x.row(i) << 1, r.scaled.transpose();
    s2[i] = r.variance, half_freedom[i] = 0.5 * r.freedom;
  }
  const double mean = s2.dot(half_freedom) / half_freedom.sum();
  if (!(mean > 0)) return {};
  const VectorXd centre = (half_freedom.transpose() * x).transpose() / half_freedom.sum();
  x.rightCols(d).rowwise() -= centre.tail(d).transpose();
  s2 = s2.cwiseMax(kLeast * mean);
  VectorXd beta = VectorXd::Zero(d + 1);
  beta[0] = std::log(mean);
  VectorXd prior = VectorXd::Constant(d + 1, 1 / (kSlopeSpread * kSlopeSpread));
  prior[0] = 0;
  for (int step = 0; step < 50; ++step) {  // Fisher scoring
    const VectorXd off = (s2.array() * (-(x * beta).array()).exp() - 1) * half_freedom.array();
    const MatrixXd information = x.transpose() * half_freedom.asDiagonal() * x + MatrixXd(prior.asDiagonal());
    const VectorXd change = information.ldlt().solve(x.transpose() * off - prior.cwiseProduct(beta));
    beta += change.cwiseMax(-1.0).cwiseMin(1.0);
    if (change.norm() < 1e-9) break;
  }
  return {{beta.data() + 1, beta.data() + beta.size()}, {centre.data() + 1, centre.data() + centre.size()}};
}

}  // namespace regolab::surrogate
