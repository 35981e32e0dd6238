#include "scheduler/surrogate/levenberg_marquardt.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::surrogate {
namespace {

/// y = a + b t on t = 0..5, exactly.
const Eigen::MatrixXd& line_design() {
  static const Eigen::MatrixXd design = [] {
    Eigen::MatrixXd m(6, 2);
    for (int i = 0; i < 6; ++i) m.row(i) << 1, i;
    return m;
  }();
  return design;
}

LeastSquares linear(const Eigen::MatrixXd& design, const Eigen::VectorXd& y) {
  return {.residual = [&](const Eigen::VectorXd& w) -> Eigen::VectorXd { return design * w - y; },
          .jacobian = [&](const Eigen::VectorXd&) { return design; },
          .penalised = {}};
}

TEST(LevenbergMarquardt, SolvesALineExactly) {
  const Eigen::Vector2d truth(2.5, -0.75);
  const Eigen::VectorXd y = line_design() * truth;
  const Fit fit = fit_least_squares(linear(line_design(), y), Eigen::Vector2d(100, 100), {});
  EXPECT_NEAR(fit.w(0), 2.5, 1e-12);
  EXPECT_NEAR(fit.w(1), -0.75, 1e-12);
  EXPECT_LT(fit.sum_of_squares, 1e-22);
}

TEST(LevenbergMarquardt, FixedPenaltyIsRidgeRegression) {
  Eigen::VectorXd y(6);
  y << 1.0, 1.9, 3.2, 3.9, 5.2, 5.8;
  LeastSquares problem = linear(line_design(), y);
  problem.penalised = Eigen::Vector2d(0, 1);
  const Fit fit = fit_least_squares(problem, Eigen::Vector2d(0, 0), {.penalty = 7, .watched = {}});
  Eigen::Matrix2d normal = line_design().transpose() * line_design();
  normal(1, 1) += 7;
  const Eigen::Vector2d closed = normal.inverse() * (line_design().transpose() * y);
  EXPECT_NEAR(fit.w(0), closed(0), 1e-8);
  EXPECT_NEAR(fit.w(1), closed(1), 1e-8);
  EXPECT_NEAR(fit.weights_in_use, 2 - 7 * normal.inverse()(1, 1), 1e-8);
}

TEST(LevenbergMarquardt, ReachesTheBottomOfRosenbrocksValley) {
  const LeastSquares problem{.residual = [](const Eigen::VectorXd& w) -> Eigen::VectorXd {
                               return Eigen::Vector2d(10 * (w(1) - w(0) * w(0)), 1 - w(0));
                             },
                             .jacobian = [](const Eigen::VectorXd& w) -> Eigen::MatrixXd {
                               return (Eigen::Matrix2d() << -20 * w(0), 10, -1, 0).finished();
                             },
                             .penalised = {}};
  const Fit fit = fit_least_squares(problem, Eigen::Vector2d(-1.2, 1), {});
  EXPECT_NEAR(fit.w(0), 1, 1e-8);
  EXPECT_NEAR(fit.w(1), 1, 1e-8);
}

/// Ten orthogonal columns of length sqrt(n), the first two with an effect: the fixed point of the re-estimation has a closed
/// form, penalty = gamma s^2 / |w|^2 with gamma = p n / (n + penalty) and s^2 = |r|^2 / (n - gamma).
TEST(LevenbergMarquardt, EvidenceEndsAtItsFixedPoint) {
  constexpr int kRows = 16, kWeights = 10;
  Eigen::MatrixXd walsh(kRows, kRows);
  for (int i = 0; i < kRows; ++i) {
    for (int j = 0; j < kRows; ++j) walsh(i, j) = __builtin_popcount(static_cast<unsigned>(i & j)) % 2 == 0 ? 1 : -1;
  }
  const Eigen::MatrixXd design = walsh.leftCols(kWeights);
  const Eigen::VectorXd y = 2 * walsh.col(0) - walsh.col(1) + 0.3 * walsh.col(12) + 0.2 * walsh.col(15);
  LeastSquares problem = linear(design, y);
  problem.penalised = Eigen::VectorXd::Ones(kWeights);
  const Fit fit = fit_least_squares(problem, Eigen::VectorXd::Zero(kWeights),
                                    {.mode = Penalty::kEvidence, .penalty = 0.1, .watched = {}});
  const double gamma = kWeights * kRows / (kRows + fit.penalty);
  EXPECT_NEAR(fit.weights_in_use, gamma, 1e-6);
  EXPECT_NEAR(fit.penalty, gamma * fit.sum_of_squares / ((kRows - gamma) * fit.w.squaredNorm()), 1e-3 * fit.penalty);
  EXPECT_GT(fit.penalty, 0.1);
  EXPECT_EQ(fit.end, FitEnd::kConverged);
}

TEST(LevenbergMarquardt, EarlyStoppingKeepsTheStepBestOnTheRowsHeldBack) {
  const Eigen::VectorXd y = line_design() * Eigen::Vector2d(2, 1);
  const auto held = [](const Eigen::VectorXd& w) { return (w - Eigen::Vector2d(50, 50)).squaredNorm(); };  // likes the start
  const Fit fit = fit_least_squares(linear(line_design(), y), Eigen::Vector2d(50, 50), {.watched = held, .patience = 2});
  EXPECT_EQ(fit.end, FitEnd::kEarlyStopped);
  EXPECT_EQ(fit.steps, 2);
  EXPECT_EQ(fit.w, Eigen::Vector2d(50, 50));
  EXPECT_EQ(fit.watched, 0);
}

}  // namespace
}  // namespace regolab::surrogate
