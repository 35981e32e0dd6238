#include "scheduler/gap/smc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace regolab::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double log_normal(double z2, double log_det, int n) { return -0.5 * (z2 + log_det + n * std::log(2 * std::numbers::pi)); }

/// y = A w + e with w normal: the unit cube is mapped to w by the normal quantile, so that the exact evidence is a normal density.
struct LinearGaussian {
  MatrixXd a;
  VectorXd y;
  double noise;

  static double quantile(double u) {  // by bisection of erfc: exact enough, and plain
    double low = -10, high = 10;
    for (int i = 0; i < 60; ++i) (0.5 * std::erfc(-0.5 * (low + high) / std::numbers::sqrt2) < u ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
  }
  VectorXd operator()(const MatrixXd& u) const {
    VectorXd out(u.cols());
    for (Eigen::Index i = 0; i < u.cols(); ++i) {
      const VectorXd off = y - a * u.col(i).unaryExpr(&quantile);
      out[i] = log_normal(off.squaredNorm() / (noise * noise), 2 * static_cast<double>(y.size()) * std::log(noise), static_cast<int>(y.size()));
    }
    return out;
  }
  double exact() const {
    const MatrixXd v = a * a.transpose() + noise * noise * MatrixXd::Identity(y.size(), y.size());
    const Eigen::LLT<MatrixXd> factor(v);
    return log_normal(y.dot(factor.solve(y)), 2 * factor.matrixLLT().diagonal().array().log().sum(), static_cast<int>(y.size()));
  }
};

LinearGaussian problem(double noise) {
  LinearGaussian p{.a = MatrixXd(6, 3), .y = VectorXd(6), .noise = noise};
  p.a << 1, 0.2, 0, 0.5, -1, 0.3, 0, 0.4, 1.2, 0.3, 0.3, 0.3, -0.7, 0.1, 0.9, 1, 1, -1;
  p.y << 0.8, -0.4, 1.1, 0.2, 0.3, 0.5;
  return p;
}

class Evidence : public testing::TestWithParam<double> {};
TEST_P(Evidence, OfALinearGaussianModelIsTheExactOne) {
  const LinearGaussian p = problem(GetParam());
  const Posterior found = sample_posterior(p, 3, {.particles = 2000, .kept = 0.8, .repeats = 4, .seed = 7});
  EXPECT_NEAR(found.log_z, p.exact(), 0.1);
  EXPECT_LT(found.log_z_error, 0.1);
}
INSTANTIATE_TEST_SUITE_P(Noise, Evidence, testing::Values(1.0, 0.2, 0.05));

TEST(Evidence, PosteriorMeansAreTheExactOnes) {
  const LinearGaussian p = problem(0.2);
  const Posterior found = sample_posterior(p, 3, {.particles = 1000, .repeats = 4, .seed = 3});
  const MatrixXd precision = p.a.transpose() * p.a / 0.04 + MatrixXd::Identity(3, 3);
  const VectorXd exact = precision.llt().solve(p.a.transpose() * p.y / 0.04);
  const VectorXd spread = precision.inverse().diagonal().cwiseSqrt();
  const VectorXd mean = MatrixXd(found.u.unaryExpr(&LinearGaussian::quantile)).rowwise().mean();
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], exact[k], 0.15 * spread[k]);
}

TEST(Evidence, TwoFarModesAreBothKept) {
  const LogLikelihood two = [](const MatrixXd& u) {
    VectorXd out(u.cols());
    for (Eigen::Index i = 0; i < u.cols(); ++i) {
      const auto peak = [&](double at) { return std::exp(-0.5 * std::pow((u(0, i) - at) / 0.01, 2)); };
      out[i] = std::log(0.7 * peak(0.1) + 0.3 * peak(0.9) + 1e-300);
    }
    return out;
  };
  const Posterior found = sample_posterior(two, 2, {.particles = 2000, .repeats = 4, .seed = 5});
  EXPECT_NEAR(found.log_z, std::log(0.01 * std::sqrt(2 * std::numbers::pi)), 0.1);
  EXPECT_NEAR((found.u.row(0).array() > 0.5).cast<double>().mean(), 0.3, 0.05);
}

TEST(Evidence, SameSeedSameBits) {
  const LinearGaussian p = problem(0.2);
  const SmcOptions options{.particles = 200, .repeats = 2, .seed = 11};
  EXPECT_EQ(sample_posterior(p, 3, options).u, sample_posterior(p, 3, options).u);
  EXPECT_NE(sample_posterior(p, 3, options).u, sample_posterior(p, 3, {.particles = 200, .repeats = 2, .seed = 12}).u);
}

}  // namespace
}  // namespace regolab::gap
