/// A narrow column whose walls carry most of the weight [physics anchors, section 2; Janssen 1895].
///
/// Where grains slide down along walls that cut A out of the plane and have the perimeter P, a slice between heights z and
/// z + dz hangs on them by mu_w sigma_h P dz. With sigma_h = K sigma_v that makes dV/dz = w - V / lambda of the load V
/// through depth z, w the weight per depth and lambda = A / (P mu_w K). In weights, which spares measuring lambda and the
/// height: a column of weight W stands on its floor with
///   F(W) = S (1 - exp(-W/S)), S = w lambda,
/// and a load Q on top adds Q exp(-W/S). K is the material's; so S is read off the full column, and the law tells the rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/small_world.h"
#include "worker/generate/random.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1000;
constexpr double kDiameter = 0.01;  ///< mean; from 0.9 to 1.1 of it
constexpr double kWidth = 4 * kDiameter;
constexpr double kGravity = 9.81;
constexpr double kWallFriction = 0.2;  ///< low against the grains' own, else grains roll down the walls
constexpr double kGrainFriction = 0.4;
constexpr double kFloorSpeed = 0.05;
constexpr int kAcross = 3;  ///< spheres side by side as they are dropped

/// Poured in layers of nine, then the floor sinks until the whole column slides.
World column(int layers, std::uint64_t seed) {
  dem::LinearLaw law = elastic_law(kStiffness);
  law.tangential_stiffness = 0.75 * kStiffness;
  law.friction = kGrainFriction;
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * 0.3 * std::sqrt(kStiffness);
  World world = empty_world(law);
  world.gravity = kGravity;
  const generate::Random random(seed);
  constexpr double kCell = kWidth / kAcross;
  for (int i = 0; i < kAcross * kAcross * layers; ++i) {
    const auto draw = [&](std::uint64_t k) {
      return random.uniform(generate::Purpose::kPosition, static_cast<std::uint64_t>(i), k);
    };
    const double radius = 0.5 * kDiameter * (0.9 + 0.2 * draw(0)), play = kCell - 2 * radius;
    const int layer = i / (kAcross * kAcross);
    add_sphere(world,
               {(i % kAcross) * kCell + radius + play * draw(1), (i / kAcross % kAcross) * kCell + radius + play * draw(2),
                1.1 * kDiameter * (0.5 + layer)},
               radius);
  }
  for (int w = dem::kLeft; w <= dem::kBack; ++w) add_wall(world, w, w % 2 == 0 ? 0 : kWidth, kWallFriction);
  add_wall(world, dem::kFloor, 0, kGrainFriction);
  world.dt = dem::stable_step(world, 0.15);
  run(world, static_cast<int>(0.5 / world.dt));
  world.walls[dem::kFloor].velocity = -kFloorSpeed;
  run(world, static_cast<int>(1.5 * kDiameter / kFloorSpeed / world.dt));
  return world;
}

/// Means over some way of the floor [N].
struct Loads {
  double floor = 0;
  double contacts = 0;     ///< on all grains, upwards: floor and walls together
  double inertia = 0;      ///< gain of momentum per time: a column slides in small jerks
  double wall_normal = 0;  ///< of the four walls
  double wall_shear() const { return contacts - floor; }
  double most_shear() const { return kWallFriction * wall_normal; }
};

std::vector<std::size_t> highest_nine(const World& world) {
  const auto& z = world.bodies.z;
  std::vector<std::size_t> order(z.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return z[i] > z[j]; });
  order.resize(9);
  return order;
}

/// Lets the floor sink by `way` diameters, with `load` [N] on the nine highest spheres.
Loads sink(World& world, double way, double load = 0) {
  auto& b = world.bodies;
  const std::vector<std::size_t> highest = highest_nine(world);
  const int steps = static_cast<int>(way * kDiameter / kFloorSpeed / world.dt);
  const double before = total_momentum(world)[2];
  Loads mean;
  for (int s = 0; s < steps; ++s) {
    mean.floor += world.walls[dem::kFloor].force / steps;
    for (const dem::Load& on : b.load) mean.contacts += on.fz / steps;
    for (int w = dem::kLeft; w <= dem::kBack; ++w) mean.wall_normal += world.walls[w].force / steps;
    for (const std::size_t i : highest) dem::push_centre(b, static_cast<int>(i), {0, 0, -load / 9});
    dem::step(world);
  }
  mean.inertia = (total_momentum(world)[2] - before) / (steps * world.dt);
  return mean;
}

/// The S with F(W) = S (1 - exp(-W/S)) [N].
double saturation(double floor, double weight) {
  double s = floor;
  for (int i = 0; i < 100; ++i) s = floor / (1 - std::exp(-weight / s));
  return s;
}

/// Of four columns the floor's load scatters by 2 % from height to height, and the grains next to the floor and the open top
/// do not press the walls as those between do; 10 % of S is allowed for both.
TEST(Janssen, ColumnsHangOnTheirWallsAndLoadTheFloorByTheSaturatingLaw) {
  double s = 0;  // from the highest columns
  for (const int layers : {30, 12, 5}) {
    double weights = 0, floors = 0, shear = 0, most_shear = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      World world = column(layers, seed);
      const double weight = dem::weight(world, kGravity);
      const Loads loads = sink(world, 0.5);
      EXPECT_NEAR(loads.contacts / (weight + loads.inertia), 1, 1e-9) << "floor and walls carry the weight";
      EXPECT_LT(std::abs(loads.inertia), 0.03 * weight);
      EXPECT_LE(loads.wall_shear(), loads.most_shear());
      weights += weight, floors += loads.floor;
      shear += loads.wall_shear(), most_shear += loads.most_shear();
    }
    EXPECT_GT(shear / most_shear, 0.93) << "walls give nearly all their friction";
    if (s == 0) s = saturation(floors, weights);
    EXPECT_NEAR(floors / s, 1 - std::exp(-weights / s), 0.1) << layers << " layers";
  }
}

/// By the law 7 % of the load reach the floor; without wall friction all of it.
TEST(Janssen, WallsKeepALoadOnTopFromTheFloor) {
  double more = 0, loads = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    World world = column(30, seed);
    const double load = 0.5 * dem::weight(world, kGravity);
    const double floor = sink(world, 0.5).floor;
    sink(world, 0.5, load);
    more += sink(world, 0.5, load).floor - floor, loads += load;
  }
  EXPECT_LT(more, 0.2 * loads);
}

}  // namespace
}  // namespace regolab::test
