/// The normal spring and dashpot against closed answers [physics anchors, section 2]. A sphere of radius 1 cm, K = 1e5 N/m.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/small_world.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e5;
constexpr double kSoft = 1e2;
constexpr double kRadius = 0.01;

struct Impact {
  double restitution;
  double contact_time;  ///< while the force pushes, in units of sqrt(m_eff/K)
};

/// RECONSTRUCTED for zeta >= 1 by letting the root turn imaginary. The contact ends when the force, not the overlap, is
/// zero.
Impact without_tensile_phase(double zeta) {
  if (zeta < 1) {
    const double s = std::sqrt(1 - zeta * zeta);
    const double a = std::numbers::pi - std::atan2(2 * zeta * s, s * s - zeta * zeta);
    return {std::exp(-zeta / s * a), a / s};
  }
  if (zeta == 1) return {std::exp(-2), 2};
  const double s = std::sqrt(zeta * zeta - 1);
  const double time = std::atanh(2 * zeta * s / (2 * zeta * zeta - 1)) / s;
  return {std::exp(-zeta * time) * (zeta / s * std::sinh(s * time) - std::cosh(s * time)), time};
}

dem::LinearLaw damped_law(double zeta, double stiffness = kStiffness) {
  dem::LinearLaw law = elastic_law(stiffness);
  law.damping_is_ratio = true;
  law.normal_damping = 2 * zeta * std::sqrt(stiffness);
  return law;
}

/// Lets body 0 fly until it has touched and left again; `step_share` of sqrt(m_eff/K) is the step.
Impact measure(World& world, double effective_mass, double step_share) {
  const double unit = std::sqrt(effective_mass / kStiffness);
  world.dt = step_share * unit;
  const double before = world.bodies.vz[0] - (world.bodies.count() > 1 ? world.bodies.vz[1] : 0.0);
  int touching = 0;
  for (int i = 0; i < 20 / step_share; ++i) {
    dem::step(world);
    if (world.bodies.load[0].fz > 0)
      ++touching;
    else if (touching > 0)
      break;
  }
  const double after = world.bodies.vz[0] - (world.bodies.count() > 1 ? world.bodies.vz[1] : 0.0);
  return {-after / before, touching * step_share};
}

World sphere_above_floor(const dem::LinearLaw& law, double speed) {
  World world = empty_world(law);
  add_sphere(world, {0, 0, kRadius + 1e-9}, kRadius);
  add_wall(world, dem::kFloor, 0);
  set_velocity(world, 0, {0, 0, -speed});
  return world;
}

class Restitution : public testing::TestWithParam<double> {};

TEST_P(Restitution, OnAWallFollowsTheClosedForm) {
  World world = sphere_above_floor(damped_law(GetParam()), 0.1);
  const Impact impact = measure(world, world.bodies.mass[0], 1e-4);
  const Impact closed = without_tensile_phase(GetParam());
  EXPECT_NEAR(impact.restitution, closed.restitution, 2e-4);
  EXPECT_NEAR(impact.contact_time, closed.contact_time, 1e-3);
}

TEST_P(Restitution, OfUnequalSpheresUsesTheEffectiveMass) {
  World world = empty_world(damped_law(GetParam()));
  const int small = add_sphere(world, {0, 0, 0}, kRadius);
  const int large = add_sphere(world, {0, 0, -3 * kRadius - 1e-9}, 2 * kRadius);
  set_velocity(world, small, {0, 0, -0.05});
  set_velocity(world, large, {0, 0, 0.05});
  const double m = world.bodies.mass[0], n = world.bodies.mass[1];
  const Impact impact = measure(world, m * n / (m + n), 1e-4);
  const Impact closed = without_tensile_phase(GetParam());
  EXPECT_NEAR(impact.restitution, closed.restitution, 2e-4);
  EXPECT_NEAR(impact.contact_time, closed.contact_time, 1e-3);
}

/// The dashpot's force jumps as the spheres touch, somewhere within a step: zeta * step of the speed comes or goes by
/// chance.
TEST_P(Restitution, AtTheWorkingStepScattersByNoMoreThanTheStepAndHardlyDrifts) {
  const double zeta = GetParam();
  const double step = 0.15 * (std::sqrt(1 + zeta * zeta) - zeta);  // as stable_step takes it
  const double closed = without_tensile_phase(zeta).restitution;
  double mean = 0;
  constexpr int kStarts = 32;
  for (int start = 0; start < kStarts; ++start) {
    World world = sphere_above_floor(damped_law(zeta), 0.1);
    world.bodies.z[0] += 0.1 * step * std::sqrt(world.bodies.mass[0] / kStiffness) * start / kStarts;
    const double restitution = measure(world, world.bodies.mass[0], step).restitution;
    EXPECT_NEAR(restitution, closed, zeta * step + step * step);
    mean += restitution / kStarts;
  }
  EXPECT_NEAR(mean, closed, 0.01);
}

INSTANTIATE_TEST_SUITE_P(DampingRatios, Restitution, testing::Values(0.1, 0.2, 0.5, 0.9, 1.0, 2.0));

TEST(RestitutionFormula, GivesThePublishedDigits) {
  const double zeta[] = {0.1, 0.2, 0.5, 0.9, 1, 2}, e[] = {0.744, 0.572, 0.298, 0.155, 0.135, 0.048};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(without_tensile_phase(zeta[i]).restitution, e[i], 5e-4);
}

TEST(AbsoluteDamping, IsTheRatioTimesTwiceTheRootOfMassAndStiffness) {
  World ratio = sphere_above_floor(damped_law(0.3), 0.1);
  dem::LinearLaw absolute = elastic_law(kStiffness);
  absolute.normal_damping = 2 * 0.3 * std::sqrt(ratio.bodies.mass[0] * kStiffness);
  World same = sphere_above_floor(absolute, 0.1);
  const double m = ratio.bodies.mass[0];
  EXPECT_NEAR(measure(ratio, m, 1e-3).restitution, measure(same, m, 1e-3).restitution, 1e-12);
}

dem::LinearLaw capped_law(double zeta, double cap) {
  dem::LinearLaw law = damped_law(zeta);
  law.tangential_damping = law.normal_damping;
  law.most_damping_ratio = cap;
  return law;
}

TEST(CappedDamping, OfAnOverdampedHeadOnCollisionGivesTheRestitutionOfTheCap) {
  for (const double cap : {0.5, 1.0, 2.0}) {
    World world = empty_world(capped_law(5, cap));
    add_sphere(world, {0, 0, 0}, kRadius);
    add_sphere(world, {0, 0, -3 * kRadius - 1e-9}, 2 * kRadius);
    set_velocity(world, 0, {0, 0, -0.05});
    set_velocity(world, 1, {0, 0, 0.05});
    const double m = world.bodies.mass[0], n = world.bodies.mass[1];
    const Impact impact = measure(world, m * n / (m + n), 1e-4), closed = without_tensile_phase(cap);
    EXPECT_NEAR(impact.restitution, closed.restitution, 2e-4) << "cap " << cap;
    EXPECT_NEAR(impact.contact_time, closed.contact_time, 1e-3) << "cap " << cap;
  }
  EXPECT_GT(without_tensile_phase(1).restitution, 10 * without_tensile_phase(5).restitution) << "the cap would not show";
}

TEST(CappedDamping, CutsAbsoluteDashpotsByEachContactsMass) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.normal_damping = 2 * 5 * std::sqrt(sphere_above_floor(law, 0.1).bodies.mass[0] * kStiffness);
  law.most_damping_ratio = 1;
  World world = sphere_above_floor(law, 0.1);
  EXPECT_NEAR(measure(world, world.bodies.mass[0], 1e-4).restitution, without_tensile_phase(1).restitution, 2e-4);
}

/// Spinning, off centre and with friction, so that both dashpots work.
std::string bits_after_a_glancing_hit(double zeta, double cap) {
  dem::LinearLaw law = capped_law(zeta, cap);
  law.friction = 0.5;
  World world = sphere_above_floor(law, 0.1);
  world.walls[dem::kFloor].friction = 0.5;
  add_sphere(world, {0.5 * kRadius, 0, 3 * kRadius}, kRadius);
  set_velocity(world, 1, {0, 0, -0.5});
  set_spin(world, 1, {3, 5, 7});
  world.dt = 0.02 * std::sqrt(world.bodies.mass[0] / kStiffness);
  run(world, 4000);
  world.law.most_damping_ratio = 0;  // the only number that may differ
  return state_bytes(world);
}

TEST(CappedDamping, LeavesUnderdampedContactsBitForBitAsTheyAre) {
  EXPECT_TRUE(bits_after_a_glancing_hit(0.3, 1) == bits_after_a_glancing_hit(0.3, 0));
  EXPECT_FALSE(bits_after_a_glancing_hit(5, 1) == bits_after_a_glancing_hit(5, 0)) << "the cap would not show";
}

TEST(CappedDamping, SetsTheStepByTheCapAndNotByTheDashpot) {
  const auto step_of = [](const dem::LinearLaw& law) {
    World world = sphere_above_floor(law, 0.1);
    add_sphere(world, {0, 0, 5 * kRadius}, 2 * kRadius);
    return dem::stable_step(world, 0.15) / (0.15 * std::sqrt(world.bodies.mass[0] / kStiffness));
  };
  const auto factor = [](double zeta) { return std::sqrt(1 + zeta * zeta) - zeta; };
  EXPECT_NEAR(step_of(capped_law(5, 1)), std::sqrt(2) - 1, 1e-14);
  EXPECT_NEAR(step_of(capped_law(1.001, 1)), std::sqrt(2) - 1, 1e-14);
  EXPECT_NEAR(step_of(capped_law(5, 0)), factor(5), 1e-14);
  EXPECT_NEAR(step_of(capped_law(0.3, 1)), factor(0.3), 1e-14);
  dem::LinearLaw tangential_alone = capped_law(5, 1);
  tangential_alone.normal_damping = 0;
  EXPECT_NEAR(step_of(tangential_alone), std::sqrt(2) - 1, 1e-14);
}

/// Spheres one on another on the floor, from the largest up, at rest; soft, so that overlaps stand well above round-off.
World stack_of(std::initializer_list<double> radii) {
  World world = empty_world(damped_law(0.5, kSoft));
  world.gravity = 1.63;
  double top = 0;
  for (const double radius : radii) {
    add_sphere(world, {0, 0, top + radius}, radius);
    top += 2 * radius;
  }
  add_wall(world, dem::kFloor, 0);
  world.dt = dem::stable_step(world, 0.15);
  EXPECT_TRUE(relax(world));
  return world;
}

TEST(Weight, PressesASphereIntoThePlaneByItsWeightOverStiffness) {
  const World world = stack_of({kRadius});
  const double weight = world.bodies.mass[0] * world.gravity;
  EXPECT_NEAR(dem::wall_contacts(world)[0].overlap * kSoft / weight, 1, 1e-10);
  EXPECT_NEAR(world.walls[dem::kFloor].force / weight, 1, 1e-10);
}

TEST(Weight, OfAStackOfTwoIsCarriedBelowByBoth) {
  const World world = stack_of({kRadius, 0.5 * kRadius});
  const double lower = world.bodies.mass[0] * world.gravity, upper = world.bodies.mass[1] * world.gravity;
  EXPECT_NEAR(dem::wall_contacts(world)[0].overlap * kSoft / (lower + upper), 1, 1e-10);
  EXPECT_NEAR(dem::contacts(world)[0].overlap * kSoft / upper, 1, 1e-10);
}

/// Where between two steps the sphere touches or leaves, as a share of the step.
double share(double z_before, double z_after) { return (kRadius - z_before) / (z_after - z_before); }

/// Leapfrog conserves its own energy during contact exactly, v^2 + (K/m) x_n x_(n-1) with x the overlap. Outside, with a
/// share f of the touching step still free, that is v^2 (1 - (K/m) dt^2 f (1 - f)): so the speed after follows from the two
/// shares, and the energy comes back to (K/m) dt^2 / 4 and no worse.
TEST(ElasticImpact, KeepsTheLeapfrogsEnergyToRoundOffAndTheTrueOneToSecondOrder) {
  double worst_before = 0;
  for (const double step : {0.15, 0.075, 0.0375, 0.00015}) {
    double worst = 0;
    for (int start = 0; start < 16; ++start) {
      World world = sphere_above_floor(elastic_law(kStiffness), 0.1);
      const double mass = world.bodies.mass[0];
      world.dt = step * std::sqrt(mass / kStiffness);
      world.bodies.z[0] = kRadius + 0.1 * world.dt * (1 + start / 16.0);
      double f_in = -1, f_out = -1;
      for (int i = 0; i < 6 / step && f_out < 0; ++i) {
        const double before = world.bodies.z[0];
        dem::step(world);
        const double after = world.bodies.z[0];
        if (before >= kRadius && after < kRadius) f_in = share(before, after);
        if (before < kRadius && after >= kRadius) f_out = share(before, after);
      }
      ASSERT_GE(f_out, 0) << "never left";
      const double speed = world.bodies.vz[0] / 0.1;
      const double expected = (1 - step * step * f_in * (1 - f_in)) / (1 - step * step * f_out * (1 - f_out));
      EXPECT_NEAR(speed * speed, expected, 1e-9);
      worst = std::max(worst, std::abs(speed * speed - 1));
    }
    EXPECT_LE(worst, 0.25 * step * step / (1 - 0.25 * step * step));
    if (step == 0.075 || step == 0.0375) {
      EXPECT_LT(worst, 0.45 * worst_before) << "not of second order";
    }
    if (step == 0.00015) {
      EXPECT_LT(worst, 1e-6);
    }
    worst_before = worst;
  }
}

}  // namespace
}  // namespace regolab::test
