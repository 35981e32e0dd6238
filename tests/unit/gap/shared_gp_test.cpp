#include "scheduler/gap/shared_gp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 60 points of two inputs and a choice of two; three outputs: smooth, only the choice, noise alone.
Sample made_up() {
  Sample s{MatrixXd(60, 4), MatrixXd(60, 3), VectorXd(60)};
  for (int i = 0; i < 60; ++i) {
    const double a = std::fmod(0.5 + 0.7549 * i, 1.0), b = std::fmod(0.5 + 0.5698 * i, 1.0), dither = std::sin(137.0 * i + 1);
    s.x.row(i) << a, b, i % 2, 1 - i % 2;
    s.y.row(i) << 10 + 4 * std::sin(4 * a) + 2 * b * b + 0.01 * dither, i % 2 + 0.02 * dither, dither;
    s.weight[i] = 1 + i % 3;
  }
  return s;
}
const Groups kGroups{0, 1, 2, 2};

TEST(SharedGp, FollowsWhatIsSmoothAndKnowsNoise) {
  const Sample s = made_up();
  const SharedGp gp(s, fit_kernel(s, kGroups));
  MatrixXd x(1, 4);
  x << 0.33, 0.61, 1, 0;
  const Predicted p = gp.predict(x);
  EXPECT_NEAR(p.mean(0, 0), 10 + 4 * std::sin(4 * 0.33) + 2 * 0.61 * 0.61, 0.1);
  EXPECT_NEAR(p.mean(1, 0), 1, 0.05);
  EXPECT_NEAR(p.mean(2, 0), 0, 0.5);
  EXPECT_GT(gp.noise()[2], 0.3) << "of the output that is noise alone";
  EXPECT_LT(std::sqrt(gp.noise()[0]), 0.1);
  MatrixXd far(1, 4);
  far << 3, 3, 1, 0;
  EXPECT_GT(gp.predict(far).variance(0, 0), 20 * p.variance(0, 0));
}

TEST(SharedGp, OneOutputIsThePlainFormula) {
  const Sample all = made_up();
  const Kernel kernel = fit_kernel(all, kGroups);
  const SharedGp together(all, kernel);
  MatrixXd x(2, 4);
  x << 0.2, 0.9, 1, 0, 0.7, 0.1, 0, 1;
  for (int j = 0; j < 3; ++j) {
    Kernel own = kernel;
    own.log_noise = {kernel.log_noise[static_cast<std::size_t>(j)]};
    const SharedGp alone({all.x, all.y.col(j), all.weight}, own);
    EXPECT_TRUE(alone.predict(x).mean.row(0).isApprox(together.predict(x).mean.row(j), 1e-9));
    EXPECT_TRUE(alone.predict(x).variance.row(0).isApprox(together.predict(x).variance.row(j), 1e-9));
  }
}

TEST(SharedGp, LeavingOneOutIsTheProcessOfTheOthers) {
  const Sample all = made_up();
  const Kernel kernel = fit_kernel(all, kGroups);
  const SharedGp gp(all, kernel);
  const Predicted left = gp.leave_one_out();
  std::vector<int> rest;
  for (int i = 1; i < 60; ++i) rest.push_back(i);
  const SharedGp without({all.x(rest, Eigen::all), all.y(rest, Eigen::all), VectorXd(all.weight(rest))}, kernel);
  const Predicted direct = without.predict(all.x.topRows(1));
  for (int j = 0; j < 2; ++j) {  // centre, scale and amplitude of 59 rows differ a little from those of 60
    EXPECT_NEAR(left.mean(j, 0), direct.mean(j, 0), 0.02 * std::sqrt(all.y.col(j).array().square().mean()));
    EXPECT_NEAR(std::sqrt(left.variance(j, 0)), std::sqrt(direct.variance(j, 0)), 0.3 * std::sqrt(direct.variance(j, 0)) + 1e-3);
  }
}

TEST(SharedGp, ARowOfManyRunsCountsAsTheyDo) {
  Sample one{MatrixXd(6, 1), MatrixXd(6, 1), VectorXd::Ones(6)};
  one.x << 0, 0.2, 0.4, 0.6, 0.8, 1;
  one.y << 1.0, 1.3, 0.8, 1.9, 2.2, 1.7;
  Sample heavy = one;
  heavy.weight[2] = 1e6;
  const Kernel kernel{.group = {0}, .log_length = {0}, .log_noise = {0}};
  EXPECT_GT(std::abs(SharedGp(one, kernel).predict(one.x).mean(0, 2) - 0.8), 0.1);
  EXPECT_NEAR(SharedGp(heavy, kernel).predict(heavy.x).mean(0, 2), 0.8, 1e-3);
}

TEST(SharedGp, SameSampleSameKernel) {
  const Sample s = made_up();
  EXPECT_EQ(fit_kernel(s, kGroups).log_length, fit_kernel(s, kGroups).log_length);
}

}  // namespace
}  // namespace regolab::gap
