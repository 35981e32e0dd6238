#include "scheduler/gap/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/gap/between_codes.h"
#include "scheduler/gap/covariances.h"
#include "scheduler/gap/hypothesis.h"
#include "vocab/effects.h"

namespace regolab::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(PairedCovariance, CountsRowsThatHaveBoth) {
  MatrixXd rows(3, 2);
  rows << 1, 2, 3, NAN, -1, 4;
  const MatrixXd c = paired_covariance(rows);
  EXPECT_DOUBLE_EQ(c(0, 0), (1 + 9 + 1) / 3.0);
  EXPECT_DOUBLE_EQ(c(0, 1), (2 - 4) / 2.0);
  EXPECT_DOUBLE_EQ(c(1, 1), (4 + 16) / 2.0);
}

TEST(SoundCorrelation, HasAUnitDiagonalAndNoNegativeEigenvalue) {
  MatrixXd c(3, 3);
  c << 1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1;  // no correlation matrix: an eigenvalue of -0.8
  const MatrixXd sound = sound_correlation(c, VectorXd::Ones(3), 0);
  EXPECT_NEAR((sound.diagonal() - VectorXd::Ones(3)).norm(), 0, 1e-12);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(sound).eigenvalues()[0], 0);
}

TEST(StudentT, OfOneNumberIsTheTextbooks) {
  const double s = 2, x = 3, nu = kFreedom;
  const double expected = std::lgamma((nu + 1) / 2) - std::lgamma(nu / 2) - 0.5 * std::log(nu * M_PI * s * s) - (nu + 1) / 2 * std::log1p(x * x / (s * s) / nu);
  EXPECT_NEAR(student_t_log_density(VectorXd::Constant(1, x), MatrixXd::Constant(1, 1, s * s)), expected, 1e-12);
}

TEST(Comparison, AddsItsThreeSourcesOfError) {
  Comparison c;
  c.y = VectorXd::Zero(2), c.variance = VectorXd(2);
  c.variance << 4, 9;
  c.correlation = MatrixXd::Identity(2, 2), c.correlation(0, 1) = c.correlation(1, 0) = 0.5;
  c.error_correlation = MatrixXd::Identity(2, 2);
  c.between_codes = MatrixXd::Ones(2, 2), c.between_alone = c.by_step = c.size_variance = VectorXd::Zero(2);
  VectorXd emulator(2);
  emulator << 1, 0;
  MatrixXd expected(2, 2);
  expected << 4 + 1 + 1, 3 + 1, 3 + 1, 9 + 1;
  EXPECT_TRUE(c.covariance(c.base_error(emulator)).isApprox(expected, 1e-12));
  c.between_alone << 4, 5;  // of the variance
  expected << 1, 0.5 * 0, 0.5 * 0, 4;
  EXPECT_TRUE(c.covariance(c.base_error(emulator), 0).isApprox(expected, 1e-12)) << "of a code that differs by nothing, the specimens' own is left";
}

TEST(Comparison, ATimeStepShiftsFeaturesTogether) {
  Comparison c;
  c.error_correlation = MatrixXd::Identity(2, 2);
  c.by_step = VectorXd(2), c.size_variance = VectorXd::Constant(2, 3);
  c.by_step << 2, -1;
  MatrixXd expected(2, 2);
  expected << 1 + 3 + 4, -2, -2, 1 + 3 + 1;
  EXPECT_TRUE(c.base_error(VectorXd::Ones(2)).isApprox(expected, 1e-12));
  const Comparison one = c.subset({});
  EXPECT_EQ(one.by_step.size(), 0);
}

TEST(BetweenCodes, ASlopeOverSigma3TurnsRoundInTheMiddle) {
  const auto feature = [](const std::string& id) { return Feature{.id = id, .group = feature_info(id)->group}; };
  const MatrixXd d = between_codes({feature("void_ratio_compressed_1.25"), feature("void_ratio_compressed_10"), feature("void_ratio_compressed_5"), feature("plate_difference_5")});
  bool turned = false;
  for (Eigen::Index r = 0; r < d.cols(); ++r) turned |= d(0, r) != 0 && std::abs(d(0, r) + d(1, r)) < 1e-9 && d(2, r) * d(1, r) > 0;
  EXPECT_TRUE(turned);
  EXPECT_EQ(d.row(3).norm(), 0);
}

TEST(StrengthRange, LeavesOutWhatIsNotNoticed) {
  const Cause signed_cause{find_effect("lateral_stress_offset")}, ratio{find_effect("cohesion")};
  const StrengthRange both = StrengthRange::of(signed_cause, 200);
  EXPECT_DOUBLE_EQ(both.at(0), -800);
  EXPECT_DOUBLE_EQ(both.at(1), 5000);
  for (double u = 0; u <= 1; u += 0.01) EXPECT_GE(std::abs(both.at(u)), 200 - 1e-9);
  EXPECT_NEAR(both.at(600.0 / 5400 - 1e-6), -200, 0.1);
  const StrengthRange from = StrengthRange::of(ratio, 100);
  EXPECT_DOUBLE_EQ(from.at(0), 100);
  EXPECT_NEAR(from.at(0.5), std::sqrt(100 * 20000.0), 1e-6);
}

}  // namespace
}  // namespace regolab::gap
