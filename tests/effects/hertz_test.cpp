/// Springs that stiffen with the root of the overlap, against Hertz's closed answers.
#include <gtest/gtest.h>

#include <cmath>

#include "support/small_world.h"
#include "worker/dem/laws/hertz.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e5, kRadius = 0.01, kMatch = 1e-5;

dem::LinearLaw hertz_law(double share) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.tangential_stiffness = 0.8 * kStiffness;
  law.effects.hertz = share;
  law.effects.hertz_overlap = kMatch;
  law.effects.hertz_most = 25;
  return law;
}

World sphere_on_floor(const dem::LinearLaw& law, double overlap) {
  World world = empty_world(law);
  add_sphere(world, {0, 0, kRadius - overlap}, kRadius);
  add_wall(world, dem::kFloor, 0, 1e6);
  world.dt = dem::stable_step(world, 0.15);
  return world;
}

TEST(Hertz, ForceIsTheMixtureAndAgreesWithTheLinearSpringAtTheMatch) {
  for (const double share : {0.3, 1.0}) {
    for (const double stretch : {0.25, 1.0, 4.0, 16.0}) {
      World world = sphere_on_floor(hertz_law(share), stretch * kMatch);
      dem::compute_forces(world);
      const double linear = kStiffness * stretch * kMatch;
      EXPECT_NEAR(world.bodies.load[0].fz / (linear * (1 - share + share * std::sqrt(stretch))), 1, 1e-9);
    }
  }
}

TEST(Hertz, TangentialStiffnessGrowsAlike) {
  for (const double stretch : {0.25, 4.0}) {
    World world = sphere_on_floor(hertz_law(1), stretch * kMatch);
    dem::compute_forces(world);
    set_velocity(world, 0, {1e-4, 0, 0});
    const double before = world.bodies.x[0];
    dem::step(world);
    const double spring = dem::wall_contacts(world)[0].spring[0];
    ASSERT_GT(world.bodies.x[0], before);
    EXPECT_NEAR(-world.bodies.load[0].fx / (0.8 * kStiffness * std::sqrt(stretch) * spring), 1, 2e-2);
  }
}

TEST(Hertz, ImpactLastsAndPressesAsClosed) {
  for (const double speed : {0.02, 0.2}) {
    World world = sphere_on_floor(hertz_law(1), 0);
    set_velocity(world, 0, {0, 0, -speed});
    world.bodies.z[0] += 1e-12;
    world.dt = 1e-4 * std::sqrt(world.bodies.mass[0] / kStiffness);
    const double k = kStiffness / std::sqrt(kMatch);  // F = k u^(3/2)
    const double deepest = std::pow(1.25 * world.bodies.mass[0] * speed * speed / k, 0.4);
    const double time = 2.9433 * deepest / speed;
    double reached = 0;
    int touching = 0;
    for (int i = 0; i < static_cast<int>(2 * time / world.dt); ++i) {
      dem::step(world);
      reached = std::max(reached, kRadius - world.bodies.z[0]);
      if (world.bodies.load[0].fz > 0) ++touching;
    }
    EXPECT_NEAR(reached / deepest, 1, 1e-3);
    EXPECT_NEAR(touching * world.dt / time, 1, 1e-3);
    EXPECT_NEAR(world.bodies.vz[0] / speed, 1, 1e-4);
  }
}

TEST(Hertz, StepAllowsForTheStiffestContact) {
  World linear = sphere_on_floor(hertz_law(0), 0), root = sphere_on_floor(hertz_law(1), 0);
  EXPECT_NEAR(linear.dt / root.dt, std::sqrt(1.5 * 5), 1e-12);
}

}  // namespace
}  // namespace regolab::test
