#include "scheduler/surrogate/gaussian_process.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::surrogate {
namespace {

Observations wavy(int n, double noise) {
  Observations o{Eigen::MatrixXd(n, 2), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    const double a = std::fmod(0.5 + 0.7548776662 * i, 1.0), b = std::fmod(0.5 + 0.5698402910 * i, 1.0);  // spread over the square
    o.x.row(i) << a, b;
    o.y[i] = 3 + 2 * std::sin(4 * a) + b + noise * (2 * std::abs(std::fmod(43758.5453 * std::sin(12.9898 * i), 1.0)) - 1);
    o.runs[i] = 1 + i % 3;
  }
  return o;
}

TEST(GaussianProcess, GradientIsThatOfTheValue) {
  const Observations o = wavy(25, 0.1);
  const std::vector<double> p{0.2, -0.4, 0.3, -1.5, -2.5};
  std::vector<double> gradient;
  log_posterior(o, p, &gradient);
  for (std::size_t k = 0; k < p.size(); ++k) {
    auto up = p, down = p;
    up[k] += 1e-5, down[k] -= 1e-5;
    const double slope = (log_posterior(o, up, nullptr) - log_posterior(o, down, nullptr)) / 2e-5;
    EXPECT_NEAR(gradient[k], slope, 1e-5 * std::max(1.0, std::abs(slope))) << "parameter " << k;
  }
}

TEST(GaussianProcess, FindsASmoothFunctionAndTheNoise) {
  const Observations o = wavy(80, 0.2);
  const GaussianProcess process(o, fit_hyperparameters(o));
  for (const double a : {0.1, 0.45, 0.8}) {
    const auto p = process.predict(Eigen::Vector2d(a, 0.5));
    const double truth = 3 + 2 * std::sin(4 * a) + 0.5;
    EXPECT_NEAR(p.mean, truth, 0.1);
    EXPECT_LT(std::abs(p.mean - truth), 3 * std::sqrt(p.variance) + 0.02);
  }
  EXPECT_GT(process.predict(Eigen::Vector2d(3, 3)).variance, 20 * process.predict(Eigen::Vector2d(0.5, 0.5)).variance) << "far from all data";
}

/// The closed form against what it stands for: the same process without the group's rows.
TEST(GaussianProcess, LeavingGroupsOutIsConditioningOnTheRest) {
  const Observations all = wavy(30, 0.1);
  const Hyperparameters h{.log_length = {-0.5, 0.1}, .log_signal = 0.2, .log_trend = -2, .log_noise = -3};
  std::vector<int> group(30);
  for (int i = 0; i < 30; ++i) group[static_cast<std::size_t>(i)] = i / 2;
  const auto left_out = GaussianProcess(all, h).leave_groups_out(group);
  Observations rest{Eigen::MatrixXd(28, 2), Eigen::VectorXd(28), Eigen::VectorXd(28)};
  for (int i = 2; i < 30; ++i) rest.x.row(i - 2) = all.x.row(i), rest.y[i - 2] = all.y[i], rest.runs[i - 2] = all.runs[i];
  for (const int i : {0, 1}) {
    const auto p = GaussianProcess(rest, h).predict(all.x.row(i));
    // The outputs are standardised with and without the group, so prior scales differ a little.
    EXPECT_NEAR(left_out[static_cast<std::size_t>(i)].mean, p.mean, 0.02);
    EXPECT_NEAR(left_out[static_cast<std::size_t>(i)].variance, p.variance, 0.15 * p.variance);
  }
}

TEST(GaussianProcess, MoreSeedsLeaveLessDoubt) {
  Observations o = wavy(20, 0.1);
  const Hyperparameters h{.log_length = {0, 0}, .log_signal = 0, .log_trend = -2, .log_noise = -1};
  const double before = GaussianProcess(o, h).predict(o.x.row(0)).variance;
  o.runs *= 10;
  EXPECT_LT(GaussianProcess(o, h).predict(o.x.row(0)).variance, 0.5 * before);
}

TEST(GaussianProcess, FitsTheSameBitsAgain) {
  const Observations o = wavy(40, 0.1);
  const Hyperparameters a = fit_hyperparameters(o), b = fit_hyperparameters(o);
  EXPECT_EQ(a.log_length, b.log_length);
  EXPECT_EQ(a.log_noise, b.log_noise);
}

}  // namespace
}  // namespace regolab::surrogate
