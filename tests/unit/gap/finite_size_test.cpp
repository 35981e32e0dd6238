#include "scheduler/gap/finite_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/gap/fit.h"
#include "unit/gap/made_up_world.h"

namespace regolab::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Runs of 200 and 500 particles whose one feature is off by slope (1 - 300/n), and by a dither of its own.
FiniteSize fitted(double slope, double dither, double foretold, int runs = 40) {
  VectorXd particles(runs);
  MatrixXd residual(runs, 1);
  for (int i = 0; i < runs; ++i) {
    particles[i] = i % 2 == 0 ? 200 : 500;
    residual(i, 0) = slope * (1 - 300 / particles[i]) + dither * (i % 4 < 2 ? 1 : -1);
  }
  return {300, particles, residual, MatrixXd::Constant(runs, 1, foretold)};
}

TEST(FiniteSize, IsASlopeOverTheShareThatTouchesTheEnds) {
  const FiniteSize size = fitted(2, 0, 0);
  EXPECT_NEAR(size.at(360).mean(0, 0), 2 * (1 - 300.0 / 360), 1e-12);
  EXPECT_NEAR(size.at(240).mean(0, 0), 2 * (1 - 300.0 / 240), 1e-12);
  EXPECT_EQ(size.at(300).mean(0, 0), 0);
  EXPECT_EQ(size.at(300).variance(0, 0), 0);
  EXPECT_NEAR(size.at(1e12).mean(0, 0), 2, 1e-9) << "an endless specimen is as far as it goes";
}

TEST(FiniteSize, WhatChanceForetellsIsNoSpreadOfMaterials) {
  const double within = fitted(2, 0.3, 0.09).at(360).variance(0, 0), beyond = fitted(2, 0.3, 0).at(360).variance(0, 0);
  EXPECT_GT(within, 0) << "the slope's own error";
  EXPECT_GT(beyond, 10 * within);
}

TEST(FiniteSize, FewRunsSayNothing) {
  const Predicted p = fitted(2, 0, 0, 6).at(360);
  EXPECT_EQ(p.mean(0, 0), 0);
  EXPECT_EQ(FiniteSize().at(360).mean.size(), 0);
}

/// Of the made-up world's materials, every fourth also with 200 particles, less dense by 60 kg/m3.
MadeUpWorld world_of_two_sizes() {
  MadeUpWorld world;
  world.bank.inputs.push_back({"particles", "1"});
  for (BankRow& row : world.bank.rows) row.inputs.push_back(300);
  for (std::size_t k = 0, n = world.bank.rows.size(); k < n; k += 4) {
    BankRow row = world.bank.rows[k];
    row.inputs.back() = 200, row.features[1] -= 60;
    if (row.inputs[2] == 0 && row.inputs[3] == 0) world.bank.rows.push_back(row);
  }
  return world;
}

TEST(FiniteSize, MeasurementsAreComparedAsOfTheBanksSize) {
  const auto emulator = Emulator::from(world_of_two_sizes().bank);
  ASSERT_TRUE(emulator.ok());
  EXPECT_EQ(emulator->predict(MatrixXd::Constant(2, 1, 0.4)).mean, made_up_emulator().predict(MatrixXd::Constant(2, 1, 0.4)).mean) << "they teach materials nothing";
  ObservationSet set = measured_in_made_up_world(0.47, 4, 0, 0);
  const double usual = compare(*emulator, set).y[1];
  set.specimen.particles = 200;
  const Comparison small = compare(*emulator, set);
  EXPECT_NEAR(small.y[1] - usual, 60, 3);
  EXPECT_DOUBLE_EQ(small.measured[1].value, usual) << "shown as it was measured";
  EXPECT_DOUBLE_EQ(small.y[1] + small.size_shift[1], usual);
  EXPECT_GT(small.size_variance[1], 0);
  const Diagnosis none{.models = {{.model = "none", .cause = "none", .strength = {}, .draws = {{.values = {0.47, 4}, .strength = {}}}}}};
  EXPECT_NEAR(fits_of(*emulator, small, none)[1].base.value, emulator->predict((MatrixXd(2, 1) << 0.47, 4).finished()).mean(1, 0) - 60, 3) << "beside it, as of its size";
  set.specimen.particles.reset();
  EXPECT_EQ(compare(*emulator, set).y[1], usual) << "of a specimen that nobody counted nothing is known";
}

}  // namespace
}  // namespace regolab::gap
