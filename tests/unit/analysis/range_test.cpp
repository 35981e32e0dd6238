#include "scheduler/analysis/range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/result_tables.h"

namespace regolab::analysis {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_support::l9_rows;
using testing_support::table_of;

const std::vector<double> kNine{7, 9, 8, 9, 10, 15, 12, 12, 12};

TEST(Range, SumsMeansAndRangeOfTheArticlesEquationTwo) {
  const auto analysis = analyse_range(table_of({3, 3}, l9_rows(2), kNine), "y");
  ASSERT_TRUE(analysis.ok());
  const FactorAnalysis& a = analysis->factors[0];
  EXPECT_EQ(a.levels[0].runs, 3);
  EXPECT_NEAR(a.levels[0].sum, 24, 1e-12);
  EXPECT_NEAR(a.levels[0].mean, 8, 1e-12);
  EXPECT_NEAR(a.levels[2].mean, 12, 1e-12);
  EXPECT_NEAR(a.range, 4, 1e-12);
  EXPECT_EQ(a.highest_level, "3");
  EXPECT_EQ(a.lowest_level, "1");
  EXPECT_EQ(a.rank, 1);
  EXPECT_EQ(analysis->factors[1].rank, 2);
  EXPECT_EQ(analysis->runs_used, 9);
  EXPECT_NEAR(analysis->mean, 94.0 / 9, 1e-12);
  EXPECT_EQ(analysis->error_degrees_of_freedom, 4);
  EXPECT_NEAR(*a.levels[0].half_width_95, 2.776445 * analysis->residual_standard_deviation / std::sqrt(3.0), 1e-5);
}

TEST(Range, SpeaksDoorUnits) {
  ResultTable table = table_of({3, 3}, l9_rows(2), kNine);
  table.responses[0].unit = "Pa";
  const auto analysis = analyse_range(table, "y");
  EXPECT_EQ(analysis->unit, "kPa");
  EXPECT_NEAR(analysis->factors[0].range, 0.004, 1e-15);
}

TEST(Range, AMissingPointIsSaidAndNotFilled) {
  std::vector<double> y = kNine;
  y[4] = NAN;
  const auto analysis = analyse_range(table_of({3, 3}, l9_rows(2), y), "y");
  ASSERT_TRUE(analysis.ok());
  EXPECT_EQ(analysis->runs_used, 8);
  EXPECT_THAT(analysis->missing, ElementsAre("point 5 seed 1: not measured"));
  EXPECT_THAT(analysis->notes, Contains(HasSubstr("1 of 9 points have no value: K sums the rest")));
  const FactorAnalysis& a = analysis->factors[0];
  EXPECT_EQ(a.levels[1].runs, 2);
  EXPECT_NEAR(a.levels[1].sum, 24, 1e-12);
  EXPECT_GT(std::abs(a.levels[1].mean - 12), 0.1);  // not the plain mean: the lost run had the middle level of B
  EXPECT_EQ(analysis->error_degrees_of_freedom, 3);
}

TEST(Range, NotFiniteCountsAsMissing) {
  ResultTable table = table_of({3, 3}, l9_rows(2), kNine);
  table.rows[0].value["y"] = INFINITY;
  EXPECT_THAT(analyse_range(table, "y")->missing, ElementsAre("point 1 seed 1: not a finite number"));
}

TEST(Range, SeedsAreAveragedAndGiveErrorBars) {
  ResultTable table = table_of({3, 3}, l9_rows(2), kNine);
  const std::size_t n = table.rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    TableRow second = table.rows[i];
    second.seed = 2;
    second.value["y"] += 0.2;
    table.rows[i].value["y"] -= 0.2;
    table.rows.push_back(second);
  }
  const auto analysis = analyse_range(table, "y");
  const auto single = analyse_range(table_of({3, 3}, l9_rows(2), kNine), "y");
  EXPECT_EQ(analysis->runs_used, 9);
  EXPECT_NEAR(analysis->factors[0].range, single->factors[0].range, 1e-12);
  EXPECT_NEAR(*analysis->factors[0].f, *single->factors[0].f, 1e-9);  // repeats of a point are no new points
  const double s = 0.2 * std::sqrt(2.0);
  EXPECT_NEAR(*analysis->seed_standard_deviation, s, 1e-12);
  EXPECT_NEAR(*analysis->factors[0].range_standard_error, s / std::sqrt(2.0) * std::sqrt(2.0 / 3),
              1e-12);  // two means of 3 points of 2 seeds
  EXPECT_FALSE(single->factors[0].range_standard_error);
  EXPECT_THAT(analysis->notes, Contains(HasSubstr("mean over 2 seeds")));
}

/// A does nothing; B and C lower the response by 5 at their level 3, D by 3 at its level 1. Run 9 is 30 too high: spread
/// over the 6 runs of its levels that looks like an effect of 5 of A, and hides B and C.
TEST(Range, AnEffectThatLeansOnOneRunIsFragile) {
  std::vector<std::vector<int>> rows;
  std::vector<double> y;
  for (int run = 0; run < 18; ++run) {
    std::vector<int> row = l9_rows(3)[static_cast<std::size_t>(run % 9)];
    row.push_back(run / 9);
    const int c_level = l9_rows(3)[8][2];
    const double wobble = 0.05 * (run % 4);
    y.push_back(20 + wobble + (run == 8 ? 30 : 0) - (row[1] == 2 ? 5 : 0) - (row[2] == c_level ? 5 : 0) -
                (row[3] == 0 ? 3 : 0));
    rows.push_back(std::move(row));
  }
  const auto analysis = analyse_range(table_of({3, 3, 3, 2}, rows, y), "y");
  const FactorAnalysis& a = analysis->factors[0];
  EXPECT_NEAR(a.range, 5, 0.2);
  EXPECT_EQ(a.rank, 1);
  EXPECT_EQ(a.leaning_on_point, 9);
  EXPECT_LT(a.leave_one_out_range_min, 0.2);
  EXPECT_TRUE(a.fragile);
  EXPECT_THAT(a.fragile_why, HasSubstr("without point 9 R goes from"));
  EXPECT_FALSE(analysis->factors[1].fragile);  // B is hidden, not made up
  EXPECT_NEAR(analysis->factors[1].leave_one_out_range_max, 5, 0.2);
}

TEST(Range, ASolidEffectIsNotFragile) {
  std::vector<double> y;
  const auto rows = l9_rows(3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    y.push_back(10 * rows[i][0] + 0.01 * static_cast<double>(i % 2) + 0.02 * rows[i][1]);
  const auto analysis = analyse_range(table_of({3, 3, 3}, rows, y), "y");
  EXPECT_FALSE(analysis->factors[0].fragile);
  EXPECT_LT(*analysis->factors[0].p, 1e-4);
}

TEST(Range, UnknownResponseNamesTheKnownOnes) {
  const auto analysis = analyse_range(table_of({3, 3}, l9_rows(2), kNine), "z");
  ASSERT_FALSE(analysis.ok());
  EXPECT_EQ(analysis.error().code, Code::kNotFound);
  EXPECT_THAT(analysis.error().text, HasSubstr("no response 'z' (the experiment has: y)"));
}

TEST(Range, ADamagedTableIsRefused) {
  ResultTable table = table_of({3, 3}, l9_rows(2), kNine);
  table.rows[4].level.clear();
  EXPECT_EQ(analyse_range(table, "y").error().code, Code::kDataLoss);
  table.rows[4].level = {0, 3};
  EXPECT_EQ(analyse_range(table, "y").error().code, Code::kDataLoss);
}

TEST(Range, NothingMeasuredYet) {
  ResultTable table = table_of({3, 3}, l9_rows(2), std::vector<double>(9, NAN));
  const auto analysis = analyse_range(table, "y");
  ASSERT_FALSE(analysis.ok());
  EXPECT_EQ(analysis.error().code, Code::kFailedPrecondition);
  EXPECT_THAT(analysis.error().text,
              HasSubstr("y is known at 0 of 9 points (two are needed; point 1 seed 1: not measured)"));
  EXPECT_FALSE(analyse_ranges(table, "").ok());
}

TEST(Range, EmptyMeansPrimaryAndAllMeansAll) {
  ResultTable table = table_of({3, 3}, l9_rows(2), kNine);
  table.responses = {{"bulk_density", "kg/m3"}, {"core_density", "kg/m3"}, {"repose_angle", "rad"}};
  for (TableRow& row : table.rows) row.value = {{"bulk_density", row.value.at("y")}, {"core_density", row.value.at("y")}};
  EXPECT_EQ(analyse_ranges(table, "")->size(), 1u);  // repose_angle has no value
  EXPECT_EQ(analyse_ranges(table, "all")->size(), 2u);
  EXPECT_EQ(analyse_ranges(table, "core_density")->front().response, "core_density");
  EXPECT_FALSE(analyse_ranges(table, "repose_angle").ok());
}

TEST(Range, ALevelThatLostAllItsRunsIsSaid) {
  std::vector<double> y = kNine;
  y[6] = y[7] = y[8] = NAN;
  const auto analysis = analyse_range(table_of({3, 3}, l9_rows(2), y), "y");
  EXPECT_THAT(analysis->notes, Contains("A = 3 has no run with a value; it is left out"));
  EXPECT_EQ(analysis->factors[0].levels[2].runs, 0);
  EXPECT_EQ(analysis->factors[0].degrees_of_freedom, 1);
  EXPECT_NE(analysis->factors[0].highest_level, "3");
}

TEST(Range, TwoPointsAreEnoughToSaySomething) {
  const auto analysis = analyse_range(table_of({2}, {{0}, {1}}, {1, 3}), "y");
  ASSERT_TRUE(analysis.ok());
  EXPECT_NEAR(analysis->factors[0].range, 2, 1e-12);
  EXPECT_FALSE(analysis->factors[0].f);
  EXPECT_EQ(analysis->factors[0].leaning_on_point, 0);
  EXPECT_THAT(analysis->notes, Contains(HasSubstr("no error degree of freedom")));
}

}  // namespace
}  // namespace regolab::analysis
