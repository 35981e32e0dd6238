/// Walls that hold a stress on a column array whose contacts answer as springs and dashpots alone.
#include <gtest/gtest.h>

#include <cmath>

#include "support/small_world.h"
#include "worker/protocol/servo.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kRadius = 0.005;
constexpr int kAcross = 3;

/// 3 x 3 x 3 equal spheres in touch on a cubic lattice; each wall touches nine of them.
World columns(double damping_ratio) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.damping_is_ratio = true;
  law.normal_damping = 2 * damping_ratio * std::sqrt(kStiffness);
  World world = empty_world(law);
  for (int i = 0; i < kAcross * kAcross * kAcross; ++i) {
    const auto at = [](int k) { return (2 * k + 1) * kRadius; };
    add_sphere(world, {at(i % 3), at(i / 3 % 3), at(i / 9)}, kRadius);
  }
  for (int axis = 0; axis < 3; ++axis) {
    add_wall(world, 2 * axis, 0);
    add_wall(world, 2 * axis + 1, 2 * kAcross * kRadius);
  }
  world.dt = dem::stable_step(world, 0.15);
  return world;
}

class ServoOnDashpots : public testing::TestWithParam<double> {};

/// With the gain of the springs alone the walls swing between their caps for ever once 2 eta exceeds K tau.
TEST_P(ServoOnDashpots, HoldsTheStressAndComesToRest) {
  World world = columns(GetParam());
  const double dashpot = 2 * GetParam() * std::sqrt(kStiffness * world.bodies.mass[0]);
  const protocol::Servo servo{.wanted = 50, .most_speed = 0.05, .dashpot = dashpot};
  protocol::ServoParts parts[3];
  const double relaxation = dashpot / kStiffness + servo.time_steps * world.dt;
  dem::compute_forces(world);
  for (double end = world.time + 100 * relaxation; world.time < end; dem::step(world)) {
    for (int axis = 0; axis < 3; ++axis) protocol::hold_stress(servo, axis, parts[axis], world);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(protocol::mean_stress(world.walls, axis), servo.wanted, 1e-3 * servo.wanted);
    EXPECT_LT(std::abs(world.walls[2 * axis].velocity), 1e-3 * servo.most_speed);
    // The column shortens by four contacts' overlaps: two at the walls, two within, each F/K.
    const double force = servo.wanted * 4 * kRadius * kRadius;
    EXPECT_NEAR(2 * kAcross * kRadius - protocol::opening(world.walls, axis), 4 * force / kStiffness, 0.04 * force / kStiffness);
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, ServoOnDashpots, testing::Values(0.1, 1.0, 10.0));

}  // namespace
}  // namespace regolab::test
