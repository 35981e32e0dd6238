/// Rolling resistance of a sphere on a plane: it rests where mu_r >= tan(slope), and rolls with 5/7 g (sin - mu_r cos) where not.
#include <gtest/gtest.h>

#include <cmath>

#include "support/small_world.h"
#include "worker/dem/laws/rolling.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e5, kRadius = 0.01, kGravity = 1.63;

World resting_sphere(double rolling, bool iwashita_oda = false) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * 0.3 * std::sqrt(kStiffness);
  law.effects.rolling = rolling;
  law.effects.iwashita_oda = iwashita_oda;
  World world = empty_world(law);
  add_sphere(world, {0, 0, kRadius}, kRadius);
  add_wall(world, dem::kFloor, 0, 1.0);
  world.gravity = kGravity;
  world.dt = 0.15 * std::sqrt(world.bodies.mass[0] / kStiffness);
  world.bodies.z[0] -= world.bodies.mass[0] * kGravity / kStiffness;
  dem::compute_forces(world);
  return world;
}

void run_on_incline(World& world, int steps, double slope) {
  world.gravity = kGravity * std::cos(slope);
  for (int i = 0; i < steps; ++i) {
    dem::push_centre(world.bodies, 0, {world.bodies.mass[0] * kGravity * std::sin(slope), 0, 0});
    dem::step(world);
  }
}

class RollingLaw : public testing::TestWithParam<bool> {};

TEST_P(RollingLaw, LetsASphereRestWhereItReachesTheSlope) {
  const double slope = std::atan(0.2);
  for (const double rolling : {0.21, 0.4}) {
    World world = resting_sphere(rolling, GetParam());
    run_on_incline(world, 20000, slope);
    const double before = world.bodies.x[0];
    run_on_incline(world, 20000, slope);
    // Two turns of the loaded spring either way is all that it may swing.
    const double turn = rolling * kRadius * world.bodies.mass[0] * kGravity /
                        dem::rolling_stiffness(world.law.effects, dem::Constant{kStiffness, kStiffness}, kRadius);
    EXPECT_LT(std::abs(world.bodies.x[0] - before), 2 * turn * kRadius) << rolling;
  }
}

TEST_P(RollingLaw, TakesItsShareFromWhatRollsDown) {
  const double slope = std::atan(0.2);
  for (const double rolling : {0.05, 0.15}) {
    World world = resting_sphere(rolling, GetParam());
    run_on_incline(world, 4000, slope);
    const double before = world.bodies.vx[0];
    run_on_incline(world, 4000, slope);
    const double closed = 5.0 / 7 * kGravity * (std::sin(slope) - rolling * std::cos(slope));
    EXPECT_NEAR((world.bodies.vx[0] - before) / (4000 * world.dt) / closed, 1, 2e-3) << rolling;
  }
}

TEST_P(RollingLaw, StopsASphereThatRollsOnThePlain) {
  const double rolling = 0.1, v0 = 0.05;
  World world = resting_sphere(rolling, GetParam());
  set_velocity(world, 0, {v0, 0, 0});
  set_spin(world, 0, {0, v0 / kRadius, 0});
  const double time = v0 / (5.0 / 7 * rolling * kGravity);
  run(world, static_cast<int>(0.5 * time / world.dt));
  EXPECT_NEAR(world.bodies.vx[0] / v0, 0.5, 5e-3);
  run(world, static_cast<int>(2 * time / world.dt));
  EXPECT_LT(std::abs(world.bodies.vx[0]), 0.02 * v0);
}

INSTANTIATE_TEST_SUITE_P(Variants, RollingLaw, testing::Values(false, true),
                         [](const auto& variant) { return variant.param ? "IwashitaOda" : "ElasticPlastic"; });

TEST(RollingMoment, IsEqualAndOppositeAndSpinAboutTheNormalMeetsNone) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.effects.rolling = 0.3;
  World world = empty_world(law);
  add_sphere(world, {0, 0, 0}, kRadius);
  add_sphere(world, {0, 0, 3 * kRadius - 1e-5}, 2 * kRadius);
  set_spin(world, 0, {0.1, 0, 7});
  world.dt = 0.1 * std::sqrt(world.bodies.mass[0] / kStiffness);
  const double about_normal = world.bodies.wz[0];
  const Vec3 before = total_angular_momentum(world);
  run(world, 20);
  EXPECT_LT(norm(total_angular_momentum(world) - before), 1e-12 * norm(before));
  EXPECT_NEAR(world.bodies.wz[0] / about_normal, 1, 1e-6);
  EXPECT_NE(world.bodies.wx[1], 0) << "no moment was given";
}

TEST(RollingMoment, RisesWithTheAngleByItsStiffnessAndEndsAtTheCap) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.effects.rolling = 0.3;
  const double reduced = 0.004, push = 2, angle = 1e-5;
  const dem::Constant k{kStiffness, kStiffness};
  dem::ContactPoint<double> c{0, 0, 1, 1e-6, 0, 0, 0, 0, 0, 0};
  dem::RollingSpring<double> r{1, 0, 0, 0, 0, 0};
  dem::rolling_moment(law, k, push, reduced, 1.0, angle, c, r);  // one step turns it by `angle`
  EXPECT_NEAR(r.mx / (-2.25 * kStiffness * 0.3 * 0.3 * reduced * reduced * angle), 1, 1e-12);
  dem::RollingSpring<double> far{1, 0, 0, 0.1, 0, 0};
  dem::rolling_moment(law, k, push, reduced, 1.0, angle, c, far);
  EXPECT_NEAR(far.mx / (-0.3 * reduced * push), 1, 1e-12);
  EXPECT_NEAR(far.rx * 2.25 * kStiffness * 0.3 * 0.3 * reduced * reduced / (0.3 * reduced * push), 1, 1e-12) << "cut back to the cap";
}

}  // namespace
}  // namespace regolab::test
