/// Action and reaction, and stress from forces inside against forces on the walls [physics anchors, section 2].
#include <gtest/gtest.h>

#include <cmath>

#include "support/packing.h"
#include "support/small_world.h"

namespace regolab::test {
namespace {

TEST(Momentum, OfACollidingSwarmWithoutWallsStaysToRoundOff) {
  World world = swarm({.clusters = 60, .seed = 3, .speed = 0.3});
  for (int w = 0; w < dem::kWalls; ++w) world.walls[w].present = false;
  for (int body = 0; body < world.bodies.count(); ++body) {  // everybody flies towards the middle
    set_velocity(world, body, velocity(world, body) - 20.0 * (position(world, body) - Vec3{0.02, 0.02, 0.02}));
  }
  const Vec3 p = total_momentum(world), l = total_angular_momentum(world);
  double scale = 0;
  for (int body = 0; body < world.bodies.count(); ++body) {
    scale += world.bodies.mass[static_cast<std::size_t>(body)] * norm(velocity(world, body));
  }
  const double energy = dem::energies(world).kinetic;
  run(world, 5000);
  EXPECT_LT(dem::energies(world).kinetic, 0.8 * energy) << "hardly any collisions";
  EXPECT_LT(norm(total_momentum(world) - p), 1e-13 * scale);
  EXPECT_LT(norm(total_angular_momentum(world) - l), 1e-13 * scale * 0.04);
}

TEST(WallStress, EqualsForceTimesBranchOverVolumeInsideARestingPacking) {
  World world = pressed_packing(80, 0.3);
  const double ratio = dem::unbalanced_force_ratio(world);
  ASSERT_LT(ratio, 1e-5);
  double inside[3] = {0, 0, 0};  // sum of f l for each axis, compression positive [N m]
  for (const auto& touching : {dem::contacts(world), dem::wall_contacts(world)}) {
    for (const dem::Contact& c : touching) {
      for (std::size_t axis = 0; axis < 3; ++axis) inside[axis] -= c.force[axis] * (c.arm_a[axis] - c.arm_b[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto &low = world.walls[2 * axis], &high = world.walls[2 * axis + 1];
    EXPECT_GT(low.force, 0);
    const double outside = 0.5 * (low.force + high.force) * (high.position - low.position);
    EXPECT_NEAR(inside[axis] / outside, 1, 100 * ratio) << "axis " << axis;
  }
}

}  // namespace
}  // namespace regolab::test
