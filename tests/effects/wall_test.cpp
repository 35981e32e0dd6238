/// Walls that give way: springs in series, and dashpots at the same share of critical.
#include <gtest/gtest.h>

#include <cmath>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kRadius = 0.01, kCompliance = 19;

World squeezed(double compliance, double by) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.effects.wall_compliance = compliance;
  law.damping_is_ratio = true;
  law.normal_damping = 2 * 0.4 * std::sqrt(kStiffness);
  World world = empty_world(law);
  add_sphere(world, {0, 0, kRadius}, kRadius);
  add_sphere(world, {0, 0, 3 * kRadius}, kRadius);
  add_wall(world, dem::kFloor, 0);
  add_wall(world, dem::kTop, 4 * kRadius - by);
  world.dt = dem::stable_step(world, 0.15);
  return world;
}

TEST(CompliantWalls, AreSpringsInSeriesWithTheGrains) {
  for (const double compliance : {0.0, kCompliance}) {
    World world = squeezed(compliance, 1e-4);
    ASSERT_TRUE(relax(world));
    const double closed = 1e-4 * kStiffness / (1 + 2 * (1 + compliance));  // one contact of grains, two at walls
    EXPECT_NEAR(world.walls[dem::kTop].force / closed, 1, 1e-6);
    EXPECT_NEAR(world.walls[dem::kFloor].force / closed, 1, 1e-6);
  }
}

TEST(CompliantWalls, KeepTheRestitution) {
  const auto rebound = [](double compliance) {
    World world = squeezed(compliance, -0.1);
    world.bodies.x[1] = 1;
    set_velocity(world, 0, {0, 0, -0.01});
    world.dt = 1e-3 * std::sqrt(world.bodies.mass[0] / kStiffness);
    run(world, 40000);
    return world.bodies.vz[0] / 0.01;
  };
  EXPECT_GT(rebound(0), 0.2);
  EXPECT_NEAR(rebound(kCompliance), rebound(0), 2e-3);
}

/// A block of four spheres pressed to a side wall slides down it with g - mu_w F/m.
TEST(RubbingWalls, HoldASlidingBlockByTheirFriction) {
  const double gravity = 1.63, friction = 0.3, push = 0.15;
  const auto fall = [&](double mu, double share) {
    dem::LinearLaw law = elastic_law(kStiffness);
    law.damping_is_ratio = true;
    law.normal_damping = law.tangential_damping = 2 * 0.4 * std::sqrt(kStiffness);
    World world = empty_world(law);
    const double r = kRadius, f = share * push;
    add_clump(world, {{{0, -r, -r}, {0, r, -r}, {0, -r, r}, {0, r, r}}, {r, r, r, r}}, {r, 0, 0});
    add_wall(world, dem::kLeft, 0, mu);
    world.gravity = gravity;
    world.dt = dem::stable_step(world, 0.15);
    const auto pressed = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        dem::push_centre(world.bodies, 0, {-f, 0, 0});
        dem::step(world);
      }
    };
    pressed(3000);
    const double before = world.bodies.vz[0];
    pressed(3000);
    return std::pair{-(world.bodies.vz[0] - before) / (3000 * world.dt), mu * f / world.bodies.mass[0]};
  };
  const auto [sliding, taken] = fall(friction, 1);
  ASSERT_LT(taken, gravity);
  EXPECT_NEAR(sliding / (gravity - taken), 1, 2e-2);
  EXPECT_NEAR(fall(friction, 10).first, 0, 1e-3 * gravity) << "held";
  EXPECT_NEAR(fall(0, 1).first / gravity, 1, 1e-6);
}

}  // namespace
}  // namespace regolab::test
