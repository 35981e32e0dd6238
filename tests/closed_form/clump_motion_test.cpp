/// Rigid clusters: free spin, an off-centre hit, and rest, sliding and tipping on an incline [physics anchors, section 2].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e5;
constexpr double kGravity = 1.63;

generate::Clump clump_of(int spheres) {
  const auto ratios = generate::axis_ratios(0.5, 0.5, 0.5);
  if (spheres == 2) return generate::two_element(0.01, generate::TwoKind::kAC, ratios);
  return spheres == 4 ? generate::four_element(0.01, ratios) : generate::six_element(0.01, ratios);
}

World free_clump(int spheres) {
  World world = empty_world(elastic_law(kStiffness));
  add_clump(world, clump_of(spheres), {0, 0, 0});
  return world;
}

/// Principal axis k (inertia rising) in space.
Vec3 principal_axis(const World& world, std::size_t k) {
  const auto r = dem::rotation_of(world.bodies, 0);
  return {r[k], r[3 + k], r[6 + k]};
}

double spin_energy(const World& world) {
  const auto& b = world.bodies;
  return 0.5 * (b.lx[0] * b.wx[0] + b.ly[0] * b.wy[0] + b.lz[0] * b.wz[0]);
}

TEST(FreeSpin, OfASymmetricClumpPrecessesAtAngularMomentumOverCrossInertia) {
  double error_before = 0;
  for (const double step : {2e-4, 1e-4, 5e-5}) {
    World world = free_clump(2);
    world.dt = step;
    set_spin(world, 0, {10, 20, 5});
    const Vec3 l{world.bodies.lx[0], world.bodies.ly[0], world.bodies.lz[0]};
    const double period = 2 * std::numbers::pi / (norm(l) * world.bodies.inverse_iy[0]);
    const Vec3 start = principal_axis(world, 0);  // the long axis
    const int steps = static_cast<int>(std::lround(3 * period / step));
    world.dt = 3 * period / steps;
    run(world, steps);
    const double error = norm(principal_axis(world, 0) - start);
    EXPECT_LT(error, 3e3 * step * step * 1e2);
    if (error_before > 0) {
      EXPECT_LT(error, 0.3 * error_before) << "not of second order";
    }
    error_before = error;
    EXPECT_EQ(world.bodies.lx[0], l[0]) << "a free clump keeps its angular momentum to the bit";
  }
}

TEST(FreeSpin, OfAnAsymmetricClumpKeepsItsEnergyToSecondOrder) {
  double drift_before = 0;
  for (const double step : {2e-4, 1e-4}) {
    World world = free_clump(6);
    set_spin(world, 0, {10, 20, 5});
    world.dt = step;
    run(world, 1);
    const double start = spin_energy(world);
    double worst = 0;
    for (int i = 0; i < 2.0 / step; ++i) {  // about 7 turns
      dem::step(world);
      worst = std::max(worst, std::abs(spin_energy(world) / start - 1));
    }
    EXPECT_LT(worst, 1e-5);
    if (drift_before > 0) {
      EXPECT_LT(worst, 0.3 * drift_before);
    }
    drift_before = worst;
  }
}

/// Smallest cosine between the spin's principal axis and where it pointed at first, over many turns.
double steadiness(std::size_t axis) {
  World world = free_clump(6);
  world.dt = 2e-4;
  const Vec3 start = principal_axis(world, axis);
  set_spin(world, 0, 20.0 * start + 0.02 * principal_axis(world, (axis + 1) % 3));
  double least = 1;
  for (int i = 0; i < 40000; ++i) {
    dem::step(world);
    least = std::min(least, dot(principal_axis(world, axis), start));
  }
  return least;
}

TEST(FreeSpin, AboutTheMiddleAxisTurnsOverAndAboutTheOthersDoesNot) {
  EXPECT_GT(steadiness(0), 0.999);
  EXPECT_LT(steadiness(1), -0.9);
  EXPECT_GT(steadiness(2), 0.999);
}

TEST(OffCentreHit, GivesTheImpulseOfMassAndInertiaTogether) {
  for (const int spheres : {2, 4, 6}) {
    World world = empty_world(elastic_law(kStiffness));
    add_clump(world, clump_of(spheres), {0, 0, 0.05});
    turn(world, 0, {0.6, 0.8, 0}, 0.7);
    turn(world, 0, {0, 0, 1}, 0.4);
    double lowest = 1;
    std::size_t foot = 0;
    const dem::Centres at = dem::sphere_centres(world.bodies, world.spheres);
    for (std::size_t s = 0; s < at.x.size(); ++s) {
      const double bottom = at.z[s] - world.spheres.radius[s];
      if (bottom < lowest) lowest = bottom, foot = s;
    }
    add_wall(world, dem::kFloor, lowest - 1e-9);
    const double speed = 1e-3;
    set_velocity(world, 0, {0, 0, -speed});
    const Vec3 n{0, 0, 1};
    const Vec3 arm{at.x[foot] - world.bodies.x[0], at.y[foot] - world.bodies.y[0], lowest - world.bodies.z[0]};
    const Vec3 turning = cross(arm, n);
    ASSERT_GT(norm(turning), 1e-3) << "the hit is off the centre";
    const double compliance = 1 / world.bodies.mass[0] + dot(turning, inverse_inertia_times(world, 0, turning));
    world.dt = 1e-3 / std::sqrt(compliance * kStiffness);
    run(world, 4000);  // the contact lasts pi / 1e-3 steps
    ASSERT_EQ(dem::wall_contacts(world).size(), 0u);
    const double impulse = 2 * speed / compliance;
    EXPECT_NEAR(world.bodies.mass[0] * (world.bodies.vz[0] + speed) / impulse, 1, 1e-3) << spheres << " spheres";
    const Vec3 l{world.bodies.lx[0], world.bodies.ly[0], world.bodies.lz[0]};
    EXPECT_NEAR(norm(l - impulse * turning) / (impulse * norm(turning)), 0, 2e-3);
  }
}

/// A clump at rest on the floor, feet down, under the Moon's gravity.
World standing_clump(int spheres, double friction) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * 0.3 * std::sqrt(kStiffness);
  World world = empty_world(law);
  world.gravity = kGravity;
  add_clump(world, clump_of(spheres), {0, 0, 0.012});
  turn(world, 0, {0.6, 0.8, 0}, 0.4);
  add_wall(world, dem::kFloor, 0, 0.5);
  world.dt = dem::stable_step(world, 0.15);
  world.drag = 20;
  run(world, 40000);
  world.drag = 0;
  run(world, 20000);
  world.walls[dem::kFloor].friction = friction;
  return world;
}

void run_on_incline(World& world, int steps, double slope) {
  world.gravity = kGravity * std::cos(slope);
  for (int i = 0; i < steps; ++i) {
    dem::push_centre(world.bodies, 0, {world.bodies.mass[0] * kGravity * std::sin(slope), 0, 0});
    dem::step(world);
  }
}

/// Slope [rad] towards +x at which the weight passes over the edge of the feet: the largest for which the line from the
/// centre of mass along the tilted weight meets the floor inside the triangle of the feet.
double tipping_slope(const World& world) {
  std::vector<Vec3> feet;
  for (const dem::Contact& c : dem::wall_contacts(world)) feet.push_back(c.arm_a);
  double reach = -1;  // where the line y = 0 through the centre of mass leaves the triangle, towards +x
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const Vec3 &p = feet[i], &q = feet[(i + 1) % feet.size()];
    if ((p[1] > 0) == (q[1] > 0)) continue;
    reach = std::max(reach, p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1]));
  }
  return std::atan(reach / -feet.front()[2]);
}

class ClumpOnIncline : public testing::TestWithParam<int> {};

TEST_P(ClumpOnIncline, StandsOnThreeFeetAndRestsWhileItsWeightFallsInside) {
  World world = standing_clump(GetParam(), 0.5);
  ASSERT_EQ(dem::wall_contacts(world).size(), 3u);
  const double slope = std::min(0.8 * tipping_slope(world), std::atan(0.4));
  ASSERT_GT(slope, 0.05);
  const double start = world.bodies.x[0];
  run_on_incline(world, 40000, slope);
  EXPECT_NEAR(world.bodies.x[0], start, 2e-6) << "only the springs give way";
  EXPECT_LT(norm(velocity(world, 0)), 1e-6);
  EXPECT_EQ(dem::wall_contacts(world).size(), 3u);
}

TEST_P(ClumpOnIncline, SlidesWithFrictionTakenOffAndDoesNotRoll) {
  const double friction = 0.05;
  World world = standing_clump(GetParam(), friction);
  const double slope = std::min(0.8 * tipping_slope(world), 0.3);
  ASSERT_GT(std::tan(slope), 2 * friction);
  run_on_incline(world, 10000, slope);
  const double before = world.bodies.vx[0];
  run_on_incline(world, 10000, slope);
  const double acceleration = (world.bodies.vx[0] - before) / (10000 * world.dt);
  EXPECT_NEAR(acceleration / (kGravity * (std::sin(slope) - friction * std::cos(slope))), 1, 2e-3);
  EXPECT_LT(norm(spin(world, 0)), 0.05 * world.bodies.vx[0] / 0.01) << "a sphere would roll";
}

TEST_P(ClumpOnIncline, TipsOverWhereItsWeightFallsOutside) {
  World world = standing_clump(GetParam(), 5.0);  // cannot slide
  const double slope = 1.2 * tipping_slope(world);
  const Vec3 up_before = principal_axis(world, 2);
  run_on_incline(world, 60000, slope);
  EXPECT_LT(std::abs(dot(principal_axis(world, 2), up_before)), 0.99);
}

INSTANTIATE_TEST_SUITE_P(FourAndSix, ClumpOnIncline, testing::Values(4, 6));

}  // namespace
}  // namespace regolab::test
