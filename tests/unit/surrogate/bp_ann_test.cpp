#include "scheduler/surrogate/bp_ann.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "scheduler/surrogate/bp_ann_report.h"

namespace regolab::surrogate {
namespace {

using ::testing::SizeIs;

std::vector<int> numbers_to(int n) {
  std::vector<int> numbers(static_cast<std::size_t>(n));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

NetworkShape shape_of(const AnnData& data) {
  return {static_cast<int>(data.x.cols()), kHiddenUnits, static_cast<int>(data.y.cols())};
}

TEST(SplitTests, ThirtyTwoAreTwentyTwoFiveAndFiveAndEachOnce) {
  const Split split = split_tests(numbers_to(32), 1);
  EXPECT_THAT(split.training, SizeIs(22));
  EXPECT_THAT(split.validation, SizeIs(5));
  EXPECT_THAT(split.test, SizeIs(5));
  std::set<int> all(split.training.begin(), split.training.end());
  all.insert(split.validation.begin(), split.validation.end());
  all.insert(split.test.begin(), split.test.end());
  EXPECT_THAT(all, SizeIs(32));
}

TEST(SplitTests, DependsOnTheSeedAloneAndKeepsRowsOfATestTogether) {
  std::vector<int> four_pressures;
  for (const int test : numbers_to(32)) four_pressures.insert(four_pressures.end(), 4, test);
  EXPECT_EQ(split_tests(numbers_to(32), 7).training, split_tests(four_pressures, 7).training);
  EXPECT_NE(split_tests(numbers_to(32), 7).training, split_tests(numbers_to(32), 8).training);
}

TEST(QualityOf, MatchesHandFigures) {
  const FitQuality q = quality_of(Eigen::Vector4d(1, 2, 3, 4), Eigen::Vector4d(2, 2, 3, 5));
  EXPECT_NEAR(*q.r, 5 / std::sqrt(5.0 * 6.0), 1e-12);
  EXPECT_NEAR(*q.r2, 1 - 2.0 / 5.0, 1e-12);
  EXPECT_NEAR(q.rms, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(q.relative, std::sqrt(0.5) / 2.5, 1e-12);
  EXPECT_FALSE(quality_of(Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 2)).r.has_value());
}

/// Training R at or above Table 12's for every function.
TEST(BpAnn, FitsItsTrainingTestsAtLeastAsWellAsTheArticle) {
  const double article[] = {0.937, 0.891, 0.887};
  for (int function = 1; function <= 3; ++function) {
    const auto data = ann_data(article_training_table(), function);
    ASSERT_TRUE(data.ok());
    const Split split = split_tests(data->test, 1);
    const SplitTraining trained = train_on_split(*data, split, shape_of(*data), effort_for(*data).starts, 1);
    const auto rows = rows_of(data->test, split.training);
    const Eigen::MatrixXd predicted = trained.model.predict(data->x);
    double sum = 0;
    for (Eigen::Index k = 0; k < data->y.cols(); ++k) sum += *quality_of(data->y(rows, k), predicted(rows, k)).r;
    EXPECT_GE(sum / static_cast<double>(data->y.cols()), article[function - 1]) << "function " << function;
  }
}

TEST(BpAnn, PredictsContactsDensityAndVoidRatioOfTestsItNeverSaw) {
  const auto data = ann_data(article_training_table(), 1);
  ASSERT_TRUE(data.ok());
  const Eigen::MatrixXd left_out = leave_tests_out(*data, shape_of(*data), {.members = 3, .folds = 32}, 1);
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_GE(*quality_of(data->y.col(k), left_out.col(k)).r, 0.96) << k;
}

TEST(BpAnn, RetrainingGivesTheSameBits) {
  const auto data = ann_data(article_training_table(), 3);
  ASSERT_TRUE(data.ok());
  const Split split = split_tests(data->test, 3);
  const auto once = train_on_split(*data, split, shape_of(*data), 3, 3);
  const auto again = train_on_split(*data, split, shape_of(*data), 3, 3);
  EXPECT_EQ(once.chosen, again.chosen);
  EXPECT_EQ(once.model.members.front().w, again.model.members.front().w);
  EXPECT_EQ(train_ensemble(*data, shape_of(*data), 2, 3).predict(data->x),
            train_ensemble(*data, shape_of(*data), 2, 3).predict(data->x));
}

/// Wrong numbers in the held-out rows must change nothing: they are never looked at.
TEST(BpAnn, TheTestGroupHasNoSay) {
  auto data = ann_data(article_training_table(), 2);
  ASSERT_TRUE(data.ok());
  const Split split = split_tests(data->test, 1);
  const auto before = train_on_split(*data, split, shape_of(*data), 3, 1).model.members.front().w;
  for (const Eigen::Index row : rows_of(data->test, split.test)) data->y(row, 0) = 99;
  EXPECT_EQ(train_on_split(*data, split, shape_of(*data), 3, 1).model.members.front().w, before);
}

TEST(BpAnn, LeavesSetsOfTestsOutOfLargeTables) {
  AnnData data{.inputs = {"t"}, .outputs = {{"y", "1", 1}}, .test = numbers_to(65), .x = Eigen::MatrixXd(65, 1), .y = {}};
  data.x.col(0).setLinSpaced(0, 1);
  data.y = (3 * data.x.array()).sin();
  EXPECT_EQ(effort_for(data).folds, 10);
  const Eigen::MatrixXd predicted = leave_tests_out(data, shape_of(data), {.members = 1, .folds = 10}, 1);
  EXPECT_GT(*quality_of(data.y.col(0), predicted.col(0)).r, 0.999);
}

}  // namespace
}  // namespace regolab::surrogate
