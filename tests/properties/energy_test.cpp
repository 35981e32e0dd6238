/// Mechanical energy: kept without losses, paid for by walls, and only lost with friction and dashpots.
#include <gtest/gtest.h>

#include <cmath>

#include "support/packing.h"

namespace regolab::test {
namespace {

/// Largest rise of the total energy above the lowest seen before, and the energy at the start and end [J].
struct Budget {
  double start, end, largest_rise, largest_change;
};

Budget watch(World& world, int looks, int steps_between) {
  dem::compute_forces(world);
  const double start = dem::energies(world).total();
  Budget budget{start, start, 0, 0};
  double lowest = start;
  for (int look = 0; look < looks; ++look) {
    run(world, steps_between);
    const double now = dem::energies(world).total() - world.wall_work;
    budget.largest_rise = std::max(budget.largest_rise, now - lowest);
    budget.largest_change = std::max(budget.largest_change, std::abs(now - start));
    lowest = std::min(lowest, now);
    budget.end = now;
  }
  return budget;
}

TEST(Energy, OfAnElasticFrictionlessSwarmStaysWhereItIs) {
  World world = swarm({.clusters = 60, .speed = 0.3, .friction = 0, .damping = 0});
  const Budget budget = watch(world, 100, 200);
  EXPECT_LT(budget.largest_change, 0.01 * budget.start) << "over 20000 steps and hundreds of impacts";
}

TEST(Energy, OfASwarmFallingInAClosedBoxStaysWhereItIs) {
  World world = swarm({.clusters = 60, .speed = 0.1, .friction = 0, .damping = 0, .gravity = 9.81});
  const Budget budget = watch(world, 100, 200);
  EXPECT_LT(budget.largest_change, 0.01 * budget.start);
}

/// Without its noise the error must fall as the step does: what is left is the integrator's, not a leak.
TEST(Energy, ErrorFallsWithTheStep) {
  double before = 0;
  for (const double share : {1.0, 0.25}) {
    World world = swarm({.clusters = 30, .seed = 2, .speed = 0.3, .friction = 0, .damping = 0});
    world.dt *= share;
    const double change = watch(world, 50, static_cast<int>(100 / share)).largest_change;
    if (before > 0) {
      EXPECT_LT(change, 0.4 * before);
    }
    before = change;
  }
}

TEST(Energy, OnlyFallsWithFrictionAndDashpots) {
  World world = swarm({.clusters = 60, .speed = 0.3, .friction = 0.4, .damping = 0.1, .gravity = 1.63});
  const Budget budget = watch(world, 100, 200);
  EXPECT_LT(budget.end, 0.5 * budget.start);
  EXPECT_LT(budget.largest_rise, 1e-3 * budget.start);
}

TEST(Energy, GainedByAnElasticSwarmIsTheWorkOfTheClosingWalls) {
  World world = swarm({.clusters = 60, .speed = 0.1, .friction = 0, .damping = 0});
  for (int w = 0; w < dem::kWalls; ++w) world.walls[w].velocity = dem::inward(w) * 0.1;
  const Budget budget = watch(world, 100, 200);
  EXPECT_GT(world.wall_work, 0.5 * budget.start) << "the walls did too little to show anything";
  EXPECT_LT(budget.largest_change, 0.02 * (budget.start + world.wall_work));
}

/// A linear spring gives back all it took: the account of the walls' work must close to round-off, however they shake.
TEST(Energy, OfASpherePressedByShakingWallsIsTheirWork) {
  constexpr double kRadius = 0.005, kOverlap = 1e-5;
  World world = empty_world(elastic_law(1e5));
  add_sphere(world, {0, 0, kRadius}, kRadius);
  add_wall(world, dem::kFloor, kOverlap);
  add_wall(world, dem::kTop, 2 * kRadius - kOverlap);
  dem::compute_forces(world);
  const double start = dem::energies(world).total();
  for (int i = 0; i < 1000; ++i) {
    const double inward = (i % 3 == 0 ? 2 : -1) * 0.2 * kOverlap / world.dt;
    for (const int id : {dem::kFloor, dem::kTop}) world.walls[id].velocity = dem::inward(id) * inward;
    dem::step(world);
    ASSERT_NEAR(dem::energies(world).total() - world.wall_work, start, 1e-9 * start) << "step " << i;
  }
}

}  // namespace
}  // namespace regolab::test
