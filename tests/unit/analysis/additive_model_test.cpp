#include "scheduler/analysis/additive_model.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/mutate.h"
#include "support/result_tables.h"

namespace regolab::analysis {
namespace {

using testing_support::Dice;
using testing_support::l9_rows;

double uniform(Dice& dice) { return static_cast<double>(dice.next() >> 11) * 0x1p-53; }

/// The twin: 0/1 columns for every level but the first, solved densely, nothing shared with AdditiveModel.
struct Twin {
  double rss = 0;
  std::vector<std::vector<double>>
      marginal;  // [n_factors][n_levels] prediction at the level, averaged over all other level combinations
};

Twin twin_fit(const std::vector<int>& levels, const std::vector<std::vector<int>>& rows, const std::vector<double>& y,
              std::size_t left_out = 1000) {
  Eigen::Index columns = 1;
  for (std::size_t f = 0; f < levels.size(); ++f) columns += f == left_out ? 0 : levels[f] - 1;
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t run = 0; run < rows.size(); ++run) {
    const auto r = static_cast<Eigen::Index>(run);
    x(r, 0) = 1;
    Eigen::Index first = 1;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      if (f == left_out) continue;
      if (rows[run][f] > 0) x(r, first + rows[run][f] - 1) = 1;
      first += levels[f] - 1;
    }
  }
  const Eigen::Map<const Eigen::VectorXd> values(y.data(), static_cast<Eigen::Index>(y.size()));
  const Eigen::VectorXd beta = x.colPivHouseholderQr().solve(values);
  Twin twin{.rss = (values - x * beta).squaredNorm(), .marginal = {}};
  if (left_out < levels.size()) return twin;
  const auto effect = [&](std::size_t f, int level) {
    Eigen::Index first = 1;
    for (std::size_t g = 0; g < f; ++g) first += levels[g] - 1;
    return level == 0 ? 0.0 : beta[first + level - 1];
  };
  double base = beta[0];
  for (std::size_t f = 0; f < levels.size(); ++f) {
    for (int level = 0; level < levels[f]; ++level) base += effect(f, level) / levels[f];
  }
  for (std::size_t f = 0; f < levels.size(); ++f) {
    double own = 0;
    for (int level = 0; level < levels[f]; ++level) own += effect(f, level) / levels[f];
    twin.marginal.emplace_back();
    for (int level = 0; level < levels[f]; ++level) twin.marginal.back().push_back(base - own + effect(f, level));
  }
  return twin;
}

double spread(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end()) - *std::min_element(values.begin(), values.end());
}

struct Data {
  std::vector<int> levels;
  std::vector<std::vector<int>> rows;
  std::vector<double> y;
};

/// An unbalanced data set: random levels (each level at least twice), random additive effects, noise.
Data random_data(Dice& dice) {
  Data data{.levels = {2 + static_cast<int>(dice.below(3)), 2 + static_cast<int>(dice.below(3)), 2}, .rows = {}, .y = {}};
  for (int run = 0; run < 18; ++run) {
    std::vector<int> row;
    double value = 10;
    for (std::size_t f = 0; f < data.levels.size(); ++f) {
      const auto n = static_cast<std::size_t>(data.levels[f]);
      row.push_back(static_cast<int>(run < 8 ? (static_cast<std::size_t>(run) / (f + 1)) % n : dice.below(n)));
      value += static_cast<double>(row.back()) * static_cast<double>(f + 1);
    }
    data.rows.push_back(row);
    data.y.push_back(value + uniform(dice));
  }
  return data;
}

bool all_estimable(const AdditiveModel& model, const Data& data) {
  for (std::size_t f = 0; f < data.levels.size(); ++f) {
    if (!model.effect(f).estimable) return false;
  }
  return true;
}

TEST(AdditiveModel, EqualsABruteForceFitOnUnbalancedData) {
  Dice dice(3);
  int checked = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Data data = random_data(dice);
    const AdditiveModel model(data.levels, data.rows, data.y);
    if (!all_estimable(model, data)) continue;
    ++checked;
    const Twin twin = twin_fit(data.levels, data.rows, data.y);
    EXPECT_NEAR(model.residual_sum_of_squares(), twin.rss, 1e-9);
    for (std::size_t f = 0; f < data.levels.size(); ++f) {
      const Effect effect = model.effect(f);
      EXPECT_NEAR(effect.sum_of_squares, twin_fit(data.levels, data.rows, data.y, f).rss - twin.rss, 1e-8);
      EXPECT_NEAR(effect.range, spread(twin.marginal[f]), 1e-9);
      for (std::size_t level = 0; level < effect.mean.size(); ++level)
        EXPECT_NEAR(effect.mean[level], twin.marginal[f][level], 1e-9);
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(AdditiveModel, LeavingOneRunOutEqualsFittingTheRest) {
  Dice dice(4);
  int checked = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Data data = random_data(dice);
    const AdditiveModel model(data.levels, data.rows, data.y);
    for (std::size_t run = 0; run < data.rows.size(); ++run) {
      Data rest = data;
      rest.rows.erase(rest.rows.begin() + static_cast<std::ptrdiff_t>(run));
      rest.y.erase(rest.y.begin() + static_cast<std::ptrdiff_t>(run));
      const AdditiveModel refit(rest.levels, rest.rows, rest.y);
      for (std::size_t f = 0; f < data.levels.size(); ++f) {
        const auto without = model.without(run, f);
        if (!without || !all_estimable(refit, rest)) continue;
        ++checked;
        EXPECT_NEAR(without->range, refit.effect(f).range, 1e-8);
        ASSERT_EQ(without->p.has_value(), refit.effect(f).p.has_value());
        if (without->p) {
          EXPECT_NEAR(*without->p, *refit.effect(f).p, 1e-8);
        }
      }
    }
  }
  EXPECT_GT(checked, 500);
}

/// L9 with A, B; by hand: y = 10 + A effects (-2, 0, 2) + B effects (-1, 0, 1) + residuals that are orthogonal to both.
TEST(AdditiveModel, AgreesWithAHandComputedAnalysisOfVariance) {
  const std::vector<double> e{1, 0, -1, -2, 0, 2, 1, 0, -1};  // rows and columns sum to 0
  std::vector<double> y;
  for (std::size_t run = 0; run < 9; ++run) {
    y.push_back(10 + 2 * (static_cast<double>(run / 3) - 1) + (static_cast<double>(run % 3) - 1) + e[run]);
  }
  const AdditiveModel model({3, 3}, l9_rows(2), y);
  EXPECT_EQ(model.error_degrees_of_freedom(), 4);
  EXPECT_NEAR(model.residual_sum_of_squares(), 12, 1e-12);  // 1+1+4+4+1+1
  const Effect a = model.effect(0);
  EXPECT_NEAR(a.sum_of_squares, 24, 1e-12);  // 3 (4 + 0 + 4)
  EXPECT_EQ(a.degrees_of_freedom, 2);
  EXPECT_NEAR(*a.f, 4, 1e-12);        // (24/2)/(12/4)
  EXPECT_NEAR(*a.p, 1.0 / 9, 1e-12);  // for 2 and n degrees of freedom p = (1 + 2F/n)^(-n/2) = 3^-2
  EXPECT_NEAR(a.range, 4, 1e-12);
  EXPECT_NEAR(a.mean[2], 12, 1e-12);
  EXPECT_NEAR(a.mean_scale[2], 1 / std::sqrt(3.0), 1e-12);
  const Effect b = model.effect(1);
  EXPECT_NEAR(b.sum_of_squares, 6, 1e-12);
  EXPECT_NEAR(*b.f, 1, 1e-12);
}

TEST(AdditiveModel, SaturatedHasNoError) {
  const AdditiveModel model({3, 3, 3, 3}, l9_rows(4), {1, 2, 3, 4, 5, 6, 7, 8, 10});
  EXPECT_EQ(model.error_degrees_of_freedom(), 0);
  EXPECT_EQ(model.residual_standard_deviation(), 0);
  EXPECT_FALSE(model.effect(0).f);
  EXPECT_FALSE(model.without(0, 0));
}

TEST(AdditiveModel, ExactDataHaveNoF) {
  std::vector<double> y;
  for (const auto& row : l9_rows(2)) y.push_back(row[0] + 10 * row[1]);
  const AdditiveModel model({3, 3}, l9_rows(2), y);
  EXPECT_EQ(model.residual_sum_of_squares(), 0);
  EXPECT_FALSE(model.effect(1).f);
  EXPECT_NEAR(model.effect(1).range, 20, 1e-12);
}

TEST(AdditiveModel, ConfoundedFactorsAreNotToldApart) {
  std::vector<std::vector<int>> rows;
  for (int i = 0; i < 12; ++i) rows.push_back({i % 2, i % 2, i % 3});  // A and B move together
  std::vector<double> y;
  for (int i = 0; i < 12; ++i) y.push_back(5 * (i % 2) + 2 * (i % 3) + 0.01 * i);
  const AdditiveModel model({2, 2, 3}, rows, y);
  EXPECT_FALSE(model.effect(0).estimable);
  EXPECT_FALSE(model.effect(1).estimable);
  EXPECT_EQ(model.effect(0).degrees_of_freedom, 0);
  EXPECT_FALSE(model.effect(0).f);
  EXPECT_TRUE(model.effect(2).estimable);
  EXPECT_NEAR(model.effect(2).range, 4, 0.1);
}

TEST(AdditiveModel, ALevelWithoutRunsIsLeftOut) {
  const AdditiveModel model({3, 2}, {{0, 0}, {0, 1}, {2, 0}, {2, 1}, {0, 0}}, {1, 2, 5, 6, 1});
  const Effect a = model.effect(0);
  EXPECT_EQ(a.degrees_of_freedom, 1);
  EXPECT_NEAR(a.range, 4, 1e-12);
}

TEST(Distributions, MatchTheTables) {
  EXPECT_NEAR(f_tail(4.35, 3, 7), 0.05, 5e-4);
  EXPECT_NEAR(t_95(7), 2.365, 5e-4);
  EXPECT_EQ(f_tail(-1, 3, 7), 1);
}

}  // namespace
}  // namespace regolab::analysis
