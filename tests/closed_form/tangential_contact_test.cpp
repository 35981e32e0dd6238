/// The tangential spring, its cap, sliding and rolling against closed answers [physics anchors, section 2].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e5;
constexpr double kRadius = 0.01;
constexpr double kGravity = 1.63;

World sphere_on_floor(const dem::LinearLaw& law, double friction) {
  World world = empty_world(law);
  add_sphere(world, {0, 0, kRadius}, kRadius);
  add_wall(world, dem::kFloor, 0, friction);
  world.dt = 0.15 * std::sqrt(world.bodies.mass[0] / std::max(law.normal_stiffness, law.tangential_stiffness));
  return world;
}

/// At rest on the floor: pressed in by its weight, tangential spring relaxed.
World resting_sphere(double friction) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * 0.3 * std::sqrt(kStiffness);
  World world = sphere_on_floor(law, friction);
  world.gravity = kGravity;
  world.bodies.z[0] -= world.bodies.mass[0] * kGravity / kStiffness;
  dem::compute_forces(world);
  return world;
}

/// Of the sphere's surface where it touches the floor.
double surface_speed(const World& world) { return world.bodies.vx[0] - world.bodies.wy[0] * kRadius; }

class TangentialSpring : public testing::TestWithParam<double> {};

TEST_P(TangentialSpring, SwingsTheSurfaceByItsOwnPeriodDuringTheImpact) {
  const double ratio = GetParam();  // K_T / K_N
  dem::LinearLaw law = elastic_law(kStiffness);
  law.tangential_stiffness = ratio * kStiffness;
  World world = sphere_on_floor(law, 1e6);  // never slips
  set_velocity(world, 0, {1e-3, 0, -1e-3});
  world.dt *= 0.01;
  run(world, 6000);
  ASSERT_GT(world.bodies.vz[0], 0);
  EXPECT_NEAR(surface_speed(world) / 1e-3, std::cos(std::numbers::pi * std::sqrt(3.5 * ratio)), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, TangentialSpring, testing::Values(0.25, 2.0 / 7.0, 1.0, 4.0));

TEST(GrossSliding, OnAPlaneTakesFrictionTimesTheNormalImpulse) {
  const double friction = 0.3, vn = 1e-3, vt = 5e-3;
  World world = sphere_on_floor(elastic_law(kStiffness), friction);
  set_velocity(world, 0, {vt, 0, -vn});
  run(world, 60);
  const double impulse = vn + world.bodies.vz[0];  // (1 + e) v_n, per mass
  ASSERT_GT(world.bodies.vz[0], 0.99 * vn);
  ASSERT_GT(vt / vn, 3.5 * friction * 2) << "slides throughout";
  EXPECT_NEAR(world.bodies.vx[0], vt - friction * impulse, 1e-12 * vt);
  EXPECT_NEAR(world.bodies.wy[0] * kRadius / (2.5 * friction * impulse), 1, 1e-4);  // the arm is shorter by the overlap
}

TEST(GrossSliding, OfTwoUnequalSpinningSpheresIsEqualAndOpposite) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.friction = 0.2;
  World world = empty_world(law);
  const int a = add_sphere(world, {0, 0, 0}, kRadius);
  add_sphere(world, {0, 0, -3 * kRadius}, 2 * kRadius);
  set_velocity(world, a, {0, 0, -1e-3});
  set_spin(world, a, {0, 2.0, 0});  // surface speed 0.02 m/s along -x at its foot
  world.dt = 0.15 * std::sqrt(world.bodies.mass[0] / kStiffness);
  const double m = world.bodies.mass[0], n = world.bodies.mass[1];
  run(world, 80);
  const double normal = m * (world.bodies.vz[0] + 1e-3);
  ASSERT_GT(normal, 0);
  // While they touch, the small sphere walks 1e-5 of the distance between the centres: so much the normal turns.
  EXPECT_NEAR(world.bodies.vx[0] / (law.friction * normal / m), 1, 3e-5);
  EXPECT_NEAR(world.bodies.vx[1] / (-law.friction * normal / n), 1, 3e-5);
  EXPECT_NEAR(norm(total_momentum(world) - Vec3{0, 0, -1e-3 * m}), 0, 1e-17);
  const double lost = 2.5 * law.friction * normal / (m * kRadius), gained = 2.5 * law.friction * normal / (n * 2 * kRadius);
  EXPECT_NEAR((2.0 - world.bodies.wy[0]) / lost, 1, 1e-4);
  EXPECT_NEAR(-world.bodies.wy[1] / gained, 1, 1e-4);
}

TEST(SlideToRoll, EndsAtFiveSeventhsOfTheSpeedAfterTheClosedDistance) {
  const double friction = 0.3, v0 = 0.1;
  World world = resting_sphere(friction);
  set_velocity(world, 0, {v0, 0, 0});
  const double sliding_time = 2 * v0 / (7 * friction * kGravity);
  const int half = static_cast<int>(0.5 * sliding_time / world.dt);
  run(world, half);
  EXPECT_NEAR(world.bodies.vx[0] / (v0 - friction * kGravity * half * world.dt), 1,
              2e-3);  // velocities stand half a step back
  EXPECT_GT(surface_speed(world), 0.4 * v0) << "still sliding";
  run(world, 3 * half);
  EXPECT_NEAR(world.bodies.vx[0] / v0, 5.0 / 7, 1e-4);
  EXPECT_NEAR(surface_speed(world) / v0, 0, 1e-4);
  const double distance = 12 * v0 * v0 / (49 * friction * kGravity) + 5.0 / 7 * v0 * (4 * half * world.dt - sliding_time);
  EXPECT_NEAR(world.bodies.x[0] / distance, 1, 2e-3);
}

/// Gravity tilted by `slope` [rad]: the part along x acts as a force on each cluster.
void run_on_incline(World& world, int steps, double slope) {
  world.gravity = kGravity * std::cos(slope);
  for (int i = 0; i < steps; ++i) {
    dem::push_centre(world.bodies, 0, {world.bodies.mass[0] * kGravity * std::sin(slope), 0, 0});
    dem::step(world);
  }
}

double acceleration_on_incline(double friction, double slope) {
  World world = resting_sphere(friction);
  run_on_incline(world, 2000, slope);
  const double before = world.bodies.vx[0];
  run_on_incline(world, 2000, slope);
  return (world.bodies.vx[0] - before) / (2000 * world.dt);
}

TEST(Incline, ASphereRollsWhereFrictionSuffices) {
  const double slope = std::atan(0.5);  // <= 3.5 * 0.2
  EXPECT_NEAR(acceleration_on_incline(0.2, slope) / (5.0 / 7 * kGravity * std::sin(slope)), 1, 1e-3);
}

TEST(Incline, ASphereSlidesWhereItDoesNot) {
  const double slope = std::atan(1.0);  // > 3.5 * 0.2
  EXPECT_NEAR(acceleration_on_incline(0.2, slope) / (kGravity * (std::sin(slope) - 0.2 * std::cos(slope))), 1, 1e-3);
}

TEST(Incline, WithoutFrictionIsFreeFallAlongThePlane) {
  EXPECT_NEAR(acceleration_on_incline(0, 0.3) / (kGravity * std::sin(0.3)), 1, 1e-9);
}

}  // namespace
}  // namespace regolab::test
