// What must hold for any data: shifting, scaling, reordering and relabelling change only what they should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scheduler/analysis/range.h"
#include "support/mutate.h"
#include "support/result_tables.h"

namespace regolab::analysis {
namespace {

using testing_support::Dice;
using testing_support::l9_rows;
using testing_support::table_of;

std::vector<double> random_values(Dice& dice, std::size_t n) {
  std::vector<double> y;
  for (std::size_t i = 0; i < n; ++i) y.push_back(static_cast<double>(dice.below(100000)) / 1000);
  return y;
}

ResponseAnalysis analyse(const std::vector<double>& y) { return *analyse_range(table_of({3, 3, 3}, l9_rows(3), y), "y"); }

TEST(RangeProperties, SumsOfSquaresAddUpWhenBalanced) {
  Dice dice(21);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> y = random_values(dice, 9);
    const ResponseAnalysis analysis = analyse(y);
    double total = 0, parts = analysis.residual_standard_deviation * analysis.residual_standard_deviation *
                              analysis.error_degrees_of_freedom;
    for (const double value : y) total += (value - analysis.mean) * (value - analysis.mean);
    for (const FactorAnalysis& factor : analysis.factors) parts += factor.sum_of_squares;
    EXPECT_NEAR(parts, total, 1e-9 * total);
  }
}

TEST(RangeProperties, ShiftAndScale) {
  Dice dice(22);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> y = random_values(dice, 9);
    std::vector<double> changed;
    for (const double value : y) changed.push_back(-3 * value + 1000);
    const ResponseAnalysis a = analyse(y), b = analyse(changed);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(b.factors[i].range, 3 * a.factors[i].range, 1e-9);
      EXPECT_NEAR(*b.factors[i].f, *a.factors[i].f, 1e-6 * *a.factors[i].f);
      EXPECT_EQ(b.factors[i].rank, a.factors[i].rank);
      EXPECT_EQ(b.factors[i].highest_level, a.factors[i].lowest_level);
      EXPECT_EQ(b.factors[i].leaning_on_point, a.factors[i].leaning_on_point);
      EXPECT_EQ(b.factors[i].fragile, a.factors[i].fragile);
    }
  }
}

TEST(RangeProperties, OrderOfRowsDoesNotMatter) {
  Dice dice(23);
  for (int trial = 0; trial < 50; ++trial) {
    ResultTable table = table_of({3, 3, 3}, l9_rows(3), random_values(dice, 9));
    const ResponseAnalysis a = *analyse_range(table, "y");
    for (std::size_t i = table.rows.size(); i > 1; --i) std::swap(table.rows[i - 1], table.rows[dice.below(i)]);
    const ResponseAnalysis b = *analyse_range(table, "y");
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(b.factors[i].range, a.factors[i].range);
      EXPECT_EQ(b.factors[i].sum_of_squares, a.factors[i].sum_of_squares);
      EXPECT_EQ(b.factors[i].leaning_on_point, a.factors[i].leaning_on_point);
    }
  }
}

TEST(RangeProperties, RanksAreAPermutationAndBoundsHold) {
  Dice dice(24);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> y = random_values(dice, 9);
    if (trial % 2 == 1) y[dice.below(9)] = NAN;
    const ResponseAnalysis analysis = analyse(y);
    std::vector<int> ranks;
    for (const FactorAnalysis& factor : analysis.factors) {
      ranks.push_back(factor.rank);
      EXPECT_LE(factor.leave_one_out_range_min, factor.range);
      EXPECT_GE(factor.leave_one_out_range_max, factor.range);
      EXPECT_TRUE(!factor.p || (*factor.p >= 0 && *factor.p <= 1));
      EXPECT_GE(factor.sum_of_squares, 0);
    }
    std::ranges::sort(ranks);
    EXPECT_EQ(ranks, (std::vector<int>{1, 2, 3}));
  }
}

}  // namespace
}  // namespace regolab::analysis
