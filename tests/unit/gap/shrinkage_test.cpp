/// How far a gap shrinks, against cases whose answer is known in closed form.
#include "scheduler/gap/shrinkage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// `n` runs about `mean` that scatter by `sd`, their mean and scatter exact: values mean +- sd sqrt((n - 1)/n), n even.
MatrixXd balanced(const VectorXd& mean, double sd, int n) {
  MatrixXd out(mean.size(), n);
  for (int k = 0; k < n; ++k) out.col(k) = mean.array() + (k % 2 == 0 ? 1 : -1) * sd * std::sqrt((n - 1.0) / n);
  return out;
}

Target target(const VectorXd& y, double sd) { return {y, sd * sd * MatrixXd::Identity(y.size(), y.size())}; }

TEST(Shrinkage, TheGapIsWhatIsLeftWhenNoiseIsTakenOff) {
  const VectorXd y = VectorXd::Constant(6, 10.0), model = VectorXd::Constant(6, 7.0);
  const double sigma = 0.5, s = 1.2;
  const SquaredGap gap = squared_gap(target(y, sigma), balanced(model, s, 8), 1);
  EXPECT_NEAR(gap.value, (9 - sigma * sigma - s * s / 8) / (sigma * sigma), 1e-9);
  EXPECT_TRUE(gap.seen());
}

TEST(Shrinkage, IsOneLessTheRatioOfTheGaps) {
  const VectorXd y = VectorXd::Constant(8, 0.0), before = VectorXd::Constant(8, 4.0), after = VectorXd::Constant(8, 1.0);
  const double sigma = 0.1, s = 0.05;
  const Shrinkage found = shrinkage_of(target(y, sigma), balanced(before, s, 8), balanced(after, s, 8), 1);
  const double noise = sigma * sigma + s * s / 8;
  ASSERT_TRUE(found.s && found.low && found.high);
  EXPECT_NEAR(*found.s, 1 - std::sqrt((1 - noise) / (16 - noise)), 1e-9);
  EXPECT_LT(*found.low, *found.s);
  EXPECT_GT(*found.high, *found.s);
  EXPECT_GT(*found.low, 0.7);
  EXPECT_LT(*found.high, 0.8);
}

TEST(Shrinkage, AGapThatGrowsIsNegative) {
  const VectorXd y = VectorXd::Zero(8);
  const Shrinkage found = shrinkage_of(target(y, 0.1), balanced(VectorXd::Constant(8, 1.0), 0.05, 8), balanced(VectorXd::Constant(8, 2.0), 0.05, 8), 1);
  ASSERT_TRUE(found.s);
  EXPECT_NEAR(*found.s, -1, 0.02);
}

/// Over many made-up cases of truth `gap`: mean of the figure.
template <class Figure>
double mean_over_cases(double gap, double sigma, double s, int cases, const Figure& figure) {
  constexpr Index kFeatures = 5, kRuns = 8;
  double sum = 0;
  for (int c = 0; c < cases; ++c) {
    const VectorXd y = sigma * normals(kFeatures, 11, 100 * c);
    MatrixXd runs(kFeatures, kRuns);
    for (Index r = 0; r < kRuns; ++r) runs.col(r) = VectorXd::Constant(kFeatures, gap) + s * normals(kFeatures, 12, static_cast<int>(100 * c + r));
    sum += figure(target(y, sigma), runs);
  }
  return sum / cases;
}

TEST(Shrinkage, TheNoiseTakenOffIsUnbiased) {
  const double gap = 0.8, sigma = 0.4, s = 0.9;
  const auto value = [](const Target& t, const MatrixXd& runs) { return squared_gap(t, runs, 1).value; };
  const double expected = gap * gap / (sigma * sigma);
  EXPECT_NEAR(mean_over_cases(gap, sigma, s, 400, value), expected, 0.25);  // standard error 0.11
  EXPECT_NEAR(mean_over_cases(0, sigma, s, 400, value), 0, 0.12);           // standard error 0.05
}

TEST(Shrinkage, AGapWithinNoiseIsNotCalledOne) {
  const auto seen = [](const Target& t, const MatrixXd& runs) { return squared_gap(t, runs, 1).seen() ? 1.0 : 0.0; };
  EXPECT_LT(mean_over_cases(0, 0.4, 0.9, 300, seen), 0.10);
  EXPECT_GT(mean_over_cases(2.0, 0.4, 0.9, 50, seen), 0.95);
  const VectorXd y = VectorXd::Zero(4);
  const Shrinkage none = shrinkage_of(target(y, 1), balanced(VectorXd::Constant(4, 0.5), 1, 8), balanced(VectorXd::Zero(4), 1, 8), 1);
  EXPECT_FALSE(none.s || none.low || none.high);
}

TEST(Shrinkage, TheIntervalHoldsTheTruthAboutAsOftenAsItSays) {
  constexpr Index kFeatures = 10, kRuns = 8;
  constexpr double kBefore = 3, kAfter = 1, sigma = 0.5, s = 0.6;
  int held = 0, cases = 120;
  for (int c = 0; c < cases; ++c) {
    const VectorXd y = sigma * normals(kFeatures, 21, 100 * c);
    MatrixXd before(kFeatures, kRuns), after(kFeatures, kRuns);
    for (Index r = 0; r < kRuns; ++r) {
      before.col(r) = VectorXd::Constant(kFeatures, kBefore) + s * normals(kFeatures, 22, static_cast<int>(100 * c + r));
      after.col(r) = VectorXd::Constant(kFeatures, kAfter) + s * normals(kFeatures, 23, static_cast<int>(100 * c + r));
    }
    const Shrinkage found = shrinkage_of(target(y, sigma), before, after, static_cast<std::uint64_t>(c));
    ASSERT_TRUE(found.low && found.high);
    held += *found.low <= 1 - kAfter / kBefore && 1 - kAfter / kBefore <= *found.high ? 1 : 0;
  }
  EXPECT_GE(held, cases * 80 / 100);
  EXPECT_LE(held, cases * 98 / 100);
}

TEST(Shrinkage, RunsWithoutANumberAreLeftOutFeatureByFeature) {
  const VectorXd y = VectorXd::Constant(3, 10.0);
  MatrixXd runs = balanced(VectorXd::Constant(3, 7.0), 1, 8);
  const double whole = squared_gap(target(y, 0.5), runs, 1).value;
  runs.row(1).setConstant(NAN);  // no run has it
  EXPECT_NEAR(squared_gap(target(y, 0.5), runs, 1).value, whole, 1e-9) << "the others say the same";
  runs.row(2).rightCols(6).setConstant(NAN);
  EXPECT_NEAR(squared_gap(target(y, 0.5), runs, 1).value, whole, 1e-9) << "two runs are too few to know their scatter";
}

TEST(Shrinkage, TheSameSeedGivesTheSameBits) {
  const Target t = target(VectorXd::Zero(4), 0.2);
  const MatrixXd before = balanced(VectorXd::Constant(4, 1.0), 0.3, 8), after = balanced(VectorXd::Constant(4, 0.4), 0.3, 8);
  const Shrinkage a = shrinkage_of(t, before, after, 5), b = shrinkage_of(t, before, after, 5);
  EXPECT_EQ(*a.low, *b.low);
  EXPECT_EQ(*a.high, *b.high);
  EXPECT_NE(*a.low, *shrinkage_of(t, before, after, 6).low);
}

}  // namespace
}  // namespace regolab::gap
