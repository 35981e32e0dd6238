/// Attraction between two spheres: its size, its range, what it holds, and that it gives back what it takes.
#include <gtest/gtest.h>

#include <cmath>

#include "support/small_world.h"
#include "worker/dem/laws/cohesion.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kSmall = 0.004, kLarge = 0.006, kCohesion = 500;
constexpr double kDiameter = 4 * kSmall * kLarge / (kSmall + kLarge);  // harmonic mean of the diameters
constexpr double kForce = kCohesion * kDiameter * kDiameter, kRange = 0.02 * kDiameter;

/// One above the other, with this overlap; the lower one is held.
World two_spheres(double overlap, bool jkr = false, double gravity = 0) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.effects.cohesion = kCohesion;
  law.effects.jkr = jkr;
  World world = empty_world(law);
  add_sphere(world, {0, 0, 0}, kLarge);
  add_sphere(world, {0, 0, -kLarge - kSmall + overlap}, kSmall);
  world.bodies.hold_fixed(0);
  world.gravity = gravity;
  world.dt = dem::stable_step(world, 0.05);
  dem::compute_forces(world);
  return world;
}

/// On the lower sphere, upwards [N].
double pull(const World& world) { return world.bodies.load[1].fz; }

TEST(Cohesion, PullsByTheParameterTimesTheSquareOfTheDiameterAtTouch) {
  EXPECT_NEAR(pull(two_spheres(1e-12)) / kForce, 1, 1e-6);
  EXPECT_NEAR(pull(two_spheres(1e-5)) / (kForce - kStiffness * 1e-5), 1, 1e-9) << "the spring pushes beside it";
}

TEST(Cohesion, FallsToZeroOverItsRange) {
  EXPECT_NEAR(pull(two_spheres(-0.25 * kRange)) / kForce, 0.75, 1e-9);
  EXPECT_NEAR(pull(two_spheres(-0.75 * kRange)) / kForce, 0.25, 1e-9);
  EXPECT_EQ(pull(two_spheres(-1.01 * kRange)), 0);
}

TEST(Cohesion, OfTheJkrVariantWidensWithTheNeck) {
  EXPECT_NEAR(pull(two_spheres(1e-12, true)) / kForce, 1, 1e-6);
  EXPECT_NEAR(pull(two_spheres(-0.75 * kRange, true)) / kForce, 0.5, 1e-9);
  EXPECT_EQ(pull(two_spheres(-1.01 * kRange, true)), 0);
  EXPECT_NEAR((pull(two_spheres(3e-4, true)) + kStiffness * 3e-4) / kForce, std::sqrt(1 + 3e-4 / kRange), 1e-9);
}

TEST(Cohesion, HoldsAWeightUpToThePullOffForceAndNoMore) {
  const double mass = two_spheres(0).bodies.mass[1];
  for (const bool jkr : {false, true}) {
    for (const double share : {0.9, 1.1}) {
      World world = two_spheres(1e-9, jkr, 0);
      world.drag = 200;
      for (double load = 0; load < share; load += 1e-4) {  // loaded slowly
        world.gravity = load * kForce / mass;
        run(world, 20);
      }
      const bool held = world.bodies.z[1] > -kLarge - kSmall - kRange;
      EXPECT_EQ(held, share < 1) << "share " << share << ", jkr " << jkr;
    }
  }
}

TEST(Cohesion, GivesBackTheWorkItTakes) {
  for (const bool jkr : {false, true}) {
    World world = two_spheres(-2 * kRange, jkr);
    set_velocity(world, 1, {0, 0, 0.05});
    world.dt *= 0.1;
    const double before = dem::energies(world).total();
    const auto overlap = [&] { return world.bodies.z[1] + kLarge + kSmall; };
    double deepest = -1;
    for (int i = 0; i < 400000 && (deepest < 0 || overlap() > -2 * kRange); ++i) {
      dem::step(world);
      deepest = std::max(deepest, overlap());
    }
    ASSERT_GT(deepest, 0) << "never touched";
    ASSERT_LT(overlap(), -2 * kRange) << "never left";
    EXPECT_NEAR(world.bodies.vz[1] / -0.05, 1, 2e-3);
    EXPECT_NEAR(dem::energies(world).total() / before, 1, 2e-3);
  }
}

TEST(Cohesion, IsThePotentialsSlope) {
  dem::ContactEffects effects{.cohesion = kCohesion};
  for (const bool jkr : {false, true}) {
    effects.jkr = jkr;
    for (const double overlap : {-1.5 * kRange, -0.6 * kRange, 0.4 * kRange, 2 * kRange}) {
      const double h = 1e-9, reduced = 0.25 * kDiameter;
      const double slope = (dem::attraction_energy(effects, overlap + h, reduced) - dem::attraction_energy(effects, overlap - h, reduced)) / (2 * h);
      EXPECT_NEAR(-slope, dem::attraction(effects, overlap, reduced), 1e-5 * kForce);
    }
  }
}

TEST(Cohesion, LeavesWallsAlone) {
  World world = two_spheres(-1);
  add_wall(world, dem::kTop, world.bodies.z[1] + kSmall + 0.1 * kRange);
  dem::compute_forces(world);
  EXPECT_EQ(pull(world), 0);
}

/// A weightless pair held together by attraction alone still rubs: the cap stands on F_n + F_c.
TEST(Cohesion, LetsTheContactRubByThePushAlone) {
  World world = two_spheres(kForce / kStiffness);
  world.law.friction = 0.5;
  EXPECT_NEAR(pull(world), 0, 1e-9 * kForce);
  set_velocity(world, 1, {1, 0, 0});  // far beyond what the spring holds in a few steps
  run(world, 3);
  const double shear = std::hypot(world.bodies.load[1].fx, world.bodies.load[1].fy);
  EXPECT_NEAR(shear / (0.5 * kForce), 1, 0.02);
}

}  // namespace
}  // namespace regolab::test
