#include "scheduler/analysis/table_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scheduler/analysis/article.h"
#include "scheduler/analysis/range.h"
#include "support/result_tables.h"

namespace regolab::analysis {
namespace {

using ::testing::HasSubstr;
using testing_support::l9_rows;
using testing_support::table_of;

TEST(TableShape, PointsWithLevelsOfTheirOwnAreRefusedNotRanged) {
  const ResultTable box = table_of({5, 5, 2}, {{0, 3, 0}, {1, 0, 1}, {2, 4, 0}, {3, 1, 1}, {4, 2, 0}}, {1, 2, 3, 4, 5});
  EXPECT_EQ(scatters(box), "A has 5 levels at 5 points");
  for (const char* response : {"", "all", "y"}) {
    const auto ranges = analyse_ranges(box, response);
    ASSERT_FALSE(ranges.ok());
    EXPECT_EQ(ranges.error().code, Code::kFailedPrecondition);
    EXPECT_EQ(ranges.error().text,
              "a range analysis needs levels that repeat (A has 5 levels at 5 points) train a surrogate on it");
  }
}

TEST(TableShape, ArraysSweepsAndOneAtATimeDesignsAreNotScattered) {
  EXPECT_FALSE(scatters(table_of({3, 3, 3, 3}, l9_rows(4), std::vector<double>(9, 1.0)))) << "saturated, yet orthogonal";
  EXPECT_FALSE(scatters(table_of({4}, {{0}, {1}, {2}, {3}}, {1, 2, 3, 4}))) << "one factor: its level means are its runs";
  EXPECT_FALSE(scatters(table_of({2, 2}, {{0, 0}, {1, 0}, {0, 1}}, {1, 2, 3})));
  EXPECT_FALSE(scatters(article_results()));
}

TEST(TableShape, APointLeftOutIsGoneAndAnUnknownOneIsSaid) {
  const auto without = without_points(article_results(), {3, 27});
  ASSERT_TRUE(without.ok());
  EXPECT_EQ(without->rows.size(), 30U);
  const auto repose = analyse_range(*without, "repose_angle");
  ASSERT_TRUE(repose.ok());
  EXPECT_EQ(repose->runs_used, 30);
  EXPECT_GT(*repose->factors[1].p, 0.1) << "K_N";
  EXPECT_THAT(without_points(article_results(), {33}).error().text, HasSubstr("no point 33 to leave out"));
}

}  // namespace
}  // namespace regolab::analysis
