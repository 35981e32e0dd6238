#include <gmock/gmock.h>

#include <cmath>

#include "vocab/profile.h"
#include "worker/bench/estimate.h"
#include "worker/bench/report.h"
#include "worker/dem/step.h"
#include "worker/dem/watch.h"

namespace regolab::bench {
namespace {

using ::testing::AllOf;

using ::testing::HasSubstr;

MachineFigure figure_of(double us_per_step) {
  return {.clusters = 300,
          .spheres = 1800,
          .touching = {700, 170},
          .rounds = 9,
          .steps_a_round = 5000,
          .us_per_step = us_per_step,
          .least_us = 0.9 * us_per_step,
          .most_us = 1.2 * us_per_step};
}

TEST(BenchBeds, HoldTheWantedKindOfCluster) {
  for (const int spheres : {1, 2, 4, 6}) {
    const auto world = cloud({.clusters = 20, .spheres_each = spheres, .width = 0.03});
    ASSERT_TRUE(world.has_value());
    EXPECT_EQ(world->bodies.count(), 20);
    EXPECT_EQ(world->bodies.first_sphere.back(), 20 * spheres);
  }
}

TEST(BenchBeds, SayWhenThereIsNoRoom) { EXPECT_FALSE(cloud({.clusters = 20, .width = 0.009}).has_value()); }

TEST(BenchBeds, ComeNearRest) {
  auto world = cloud({.clusters = 20, .spheres_each = 2, .width = 0.03});
  ASSERT_TRUE(world.has_value());
  settle(*world);
  EXPECT_TRUE(dem::finite(*world));
  const double speed = std::sqrt(2 * dem::energies(*world).kinetic / dem::weight(*world, 1));
  EXPECT_LT(speed, 0.02) << "m/s";
  EXPECT_GT(touches(*world).grains + touches(*world).walls, 20);
  EXPECT_EQ(world->dt, kSteadyStep);
  EXPECT_EQ(world->drag, 0);
}

TEST(BenchFigure, HasItsRoundsInOrder) {
  std::vector<double> told;
  const auto figure =
      measure_machine({.bed = {.clusters = 10, .spheres_each = 2, .width = 0.03}, .rounds = 3, .steps_a_round = 50},
                      [&](double fraction) { told.push_back(fraction); });
  ASSERT_TRUE(figure.has_value());
  EXPECT_EQ(figure->spheres, 20);
  EXPECT_LE(figure->least_us, figure->us_per_step);
  EXPECT_LE(figure->us_per_step, figure->most_us);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
}

TEST(BenchEstimate, KnowsEveryProfile) {
  for (const std::string_view name : kProfileNames) {
    const auto steps = steps_of_profile(name);
    ASSERT_TRUE(steps.has_value()) << name;
    double sum = 0;
    for (const StageSteps& stage : steps->stages) {
      EXPECT_LT(stage.thousands.least, stage.thousands.mean);
      EXPECT_LT(stage.thousands.mean, stage.thousands.most);
      sum += stage.per_material * stage.thousands.mean;
    }
    EXPECT_NEAR(sum, steps->material.mean, 0.02 * sum) << name;
  }
  EXPECT_FALSE(steps_of_profile("hasty").has_value());
}

TEST(BenchEstimate, IsStepsTimesClustersTimesTheFigure) {
  ProfileSteps one{"made up",
                   "",
                   {{{StageKind::kSettle, 1, {10, 5, 20}}, {StageKind::kRepose, 1, {}}, {StageKind::kStress, 4, {}}}},
                   {10, 5, 20}};
  const Estimate times = estimate(one, 1000, 0.1);
  EXPECT_DOUBLE_EQ(times.stage_s[0].mean, 10e3 * 1000 * 0.1e-6 * load_of(StageKind::kSettle));
  EXPECT_DOUBLE_EQ(times.material_s.least, times.stage_s[0].least);
  EXPECT_DOUBLE_EQ(times.material_s.most, times.stage_s[0].most);
}

TEST(BenchReport, SaysTheFigureTheStudyAndWhatItAssumes) {
  const std::string text = report(figure_of(40), {.profile = "quick", .rows = 32, .seeds = 2, .workers = 4});
  EXPECT_THAT(text, AllOf(HasSubstr("40.0 us per step on one core (36.0 to 48.0 in 9 rounds"),
                          HasSubstr("45.0 M sphere-steps/s"), HasSubstr("study     32 rows x 2 seeds: "),
                          HasSubstr("with 4 workers"), HasSubstr("assumes   300 clusters")));
  EXPECT_THAT(report(figure_of(40), {.profile = "article"}), HasSubstr("order of magnitude"));
}

TEST(BenchReport, TakesTwiceAsLongOnAMachineHalfAsFast) {
  EXPECT_THAT(report(figure_of(40), {.rows = 1}), HasSubstr("one core; about 18 s"));
  EXPECT_THAT(report(figure_of(80), {.rows = 1}), HasSubstr("one core; about 35 s"));
}

}  // namespace
}  // namespace regolab::bench
