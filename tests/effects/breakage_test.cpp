/// Clusters that fall apart: when, and that nothing is lost.
#include "worker/effects/breakage.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support/packing.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kRadius = 0.005;

/// Two spheres side by side between floor and lid, each pressed with this force by either.
World pressed_pair(double force) {
  World world = empty_world(elastic_law(kStiffness));
  const double overlap = force / kStiffness;
  add_clump(world, {{{-kRadius, 0, 0}, {kRadius, 0, 0}}, {kRadius, kRadius}}, {0, 0, kRadius - overlap});
  add_wall(world, dem::kFloor, 0);
  add_wall(world, dem::kTop, 2 * kRadius - 2 * overlap);
  dem::compute_forces(world);
  return world;
}

TEST(Breakage, BeginsAtTheStrengthTimesTheSquareOfTheDiameter) {
  const double force = 0.1, limit = force / (4 * kRadius * kRadius);
  const World world = pressed_pair(force);
  EXPECT_TRUE(effects::overloaded(world, 1.001 * limit).empty());
  EXPECT_EQ(effects::overloaded(world, 0.999 * limit), std::vector<int>{0});
}

TEST(Breakage, SparesSinglesSpheresAndThoseHeld) {
  World single = empty_world(elastic_law(kStiffness));
  add_sphere(single, {0, 0, 0.9 * kRadius}, kRadius);
  add_wall(single, dem::kFloor, 0);
  dem::compute_forces(single);
  EXPECT_TRUE(effects::overloaded(single, 1e-9).empty());
  World held = pressed_pair(0.1);
  held.bodies.hold_fixed(0);
  EXPECT_TRUE(effects::overloaded(held, 1e-9).empty());
}

double mass_of(const World& world) { return std::accumulate(world.bodies.mass.begin(), world.bodies.mass.end(), 0.0); }
double volume_of(const World& world) {
  return std::accumulate(world.bodies.solid_volume.begin(), world.bodies.solid_volume.end(), 0.0);
}

TEST(Breakage, KeepsMassMomentumAngularMomentumAndEnergy) {
  World world = swarm({.clusters = 20, .seed = 3});
  world.near_pairs.count = world.near_walls.count = 0;
  const World before = world;
  std::vector<int> broken;
  for (int i = 0; i < world.bodies.count(); i += 3) broken.push_back(i);
  effects::break_clusters(broken, world);
  ASSERT_GT(world.bodies.count(), before.bodies.count());
  EXPECT_EQ(world.spheres.count(), before.spheres.count());
  EXPECT_NEAR(mass_of(world) / mass_of(before), 1, 1e-13);
  EXPECT_NEAR(volume_of(world) / volume_of(before), 1, 1e-13);
  EXPECT_LT(norm(total_momentum(world) - total_momentum(before)), 1e-13 * mass_of(before));
  const Vec3 turned = total_angular_momentum(world) - total_angular_momentum(before);
  EXPECT_LT(norm(turned), 1e-12 * norm(total_angular_momentum(before)));
  EXPECT_NEAR(dem::energies(world).kinetic / dem::energies(before).kinetic, 1, 1e-12);
}

TEST(Breakage, LeavesTheSpheresWhereTheyAreAndTheWorldRunsOn) {
  World world = swarm({.clusters = 30, .seed = 3, .gravity = 50});
  run(world, 3000);
  const dem::Centres before = dem::sphere_centres(world.bodies, world.spheres);
  const auto touching = dem::contacts(world).size();
  effects::break_clusters({1, 2, 7, 29}, world);
  world.dt = dem::stable_step(world, 0.15);
  dem::compute_forces(world);
  const dem::Centres after = dem::sphere_centres(world.bodies, world.spheres);
  for (std::size_t s = 0; s < before.x.size(); ++s) {
    EXPECT_NEAR(after.x[s], before.x[s], 1e-15);
    EXPECT_NEAR(after.z[s], before.z[s], 1e-15);
  }
  EXPECT_GE(dem::contacts(world).size(), touching);
  run(world, 3000);
  EXPECT_TRUE(dem::finite(world));
}

}  // namespace
}  // namespace regolab::test
