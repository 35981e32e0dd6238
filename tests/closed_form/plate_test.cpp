/// The plate of the penetration test: which way and how hard its faces, edges and corners push, and what its motion costs.
#include <gtest/gtest.h>

#include <cmath>

#include "support/packing.h"
#include "support/simd_levels.h"
#include "support/small_world.h"
#include "worker/generate/random.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kRadius = 0.002, kOverlap = 1e-4;
constexpr Vec3 kHalf{0.015, 0.0015, 0.02}, kCentre{0.01, 0.02, 0.05};

World with_plate(double friction = 0) {
  World world = empty_world(elastic_law(kStiffness));
  world.walls.plate = {.x = kCentre[0], .y = kCentre[1], .half = kHalf};
  world.walls[dem::kPlate] = {.present = true, .position = kCentre[2], .friction = friction};
  return world;
}

struct Press {
  const char* name;
  Vec3 from;       ///< the place of the plate's surface that is touched, in half edges from its centre
  Vec3 direction;  ///< of the push, not of unit length
};
constexpr double kTilt = 0.7;
const Press kPresses[] = {
    {"BottomFace", {0.3, -0.2, -1}, {0, 0, -1}},       {"SideFace", {0.3, 1, -0.4}, {0, 1, 0}},
    {"EndFace", {-1, 0.1, 0.5}, {-1, 0, 0}},           {"BottomEdge", {0.2, -1, -1}, {0, -1, -kTilt}},
    {"UprightEdge", {1, 1, 0.3}, {kTilt, 1, 0}},       {"BottomCorner", {1, -1, -1}, {1, -kTilt, -0.5}},
    {"TopCorner", {-1, 1, 1}, {-kTilt, 1, 0.5}},
};

class Plate : public testing::TestWithParam<Press> {};

TEST_P(Plate, PushesASphereAwayFromItsNearestPlace) {
  const KeepSimd keep;
  const Vec3 n = (1 / norm(GetParam().direction)) * GetParam().direction;
  for (const dem::Simd level : simd_levels()) {
    ASSERT_TRUE(dem::set_simd(level));
    World world = with_plate();
    Vec3 touched = kCentre;
    for (std::size_t axis = 0; axis < 3; ++axis) touched[axis] += GetParam().from[axis] * kHalf[axis];
    const int body = add_sphere(world, touched + (kRadius - kOverlap) * n, kRadius);
    dem::compute_forces(world);
    const Vec3 force = dem::contact_force_on(world, body);
    EXPECT_LT(norm(force - kStiffness * kOverlap * n), 1e-12) << name_of(level);
    EXPECT_LT(norm(world.walls.plate.force + force), 1e-15) << "action and reaction";
    EXPECT_EQ(world.walls[dem::kPlate].contacts, 1);
  }
}
INSTANTIATE_TEST_SUITE_P(Places, Plate, testing::ValuesIn(kPresses), [](const auto& named) { return std::string(named.param.name); });

TEST(PlateInside, PushesACentreOutThroughTheNearestFace) {
  World world = with_plate();
  const int body = add_sphere(world, kCentre + Vec3{0.001, 0.0004, -0.002}, kRadius);  // 1.1 mm from the face at y+
  dem::compute_forces(world);
  EXPECT_LT(norm(dem::contact_force_on(world, body) - Vec3{0, kStiffness * (kRadius + 0.0011), 0}), 1e-11);
}

/// Spheres at random in and around it: the packs beside the plain wall_distance, to the bit.
TEST(PlatePacks, FollowTheScalarTwinToTheBitAtEveryWidth) {
  const KeepSimd keep;
  const generate::Random random(5);
  for (const dem::Simd level : simd_levels()) {
    ASSERT_TRUE(dem::set_simd(level));
    World world = with_plate();
    add_wall(world, dem::kFloor, 0.0295);  // so that planes and plate meet in one pack
    for (std::uint64_t i = 0; i < 2500; ++i) {
      const auto along = [&](std::uint64_t axis) { return 2 * random.uniform(generate::Purpose::kWitness, 3 * i + axis) - 1; };
      add_sphere(world, kCentre + Vec3{0.017 * along(0), 0.003 * along(1), 0.022 * along(2)}, kRadius);
    }
    dem::compute_forces(world);
    int faces = 0, edges = 0, corners = 0, inside = 0;
    for (const dem::Contact& c : dem::wall_contacts(world)) {
      if (c.body_b != dem::kPlate) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(c.force[axis], kStiffness * c.overlap * c.normal[axis]) << name_of(level);
      const auto leaning = (c.normal[0] != 0) + (c.normal[1] != 0) + (c.normal[2] != 0);
      ++(c.overlap > kRadius ? inside : leaning == 1 ? faces : leaning == 2 ? edges : corners);
    }
    EXPECT_GT(faces, 100);
    EXPECT_GT(edges, 20);
    EXPECT_GT(corners, 5);
    EXPECT_GT(inside, 100);
  }
}

TEST(PlateFriction, DragsASphereThatItSlidesPastAndIsPartOfTheForceOnIt) {
  constexpr double kMu = 0.3;
  World world = with_plate(kMu);
  const double wall = kCentre[1] + kHalf[1] + 2 * (kRadius - kOverlap);
  add_wall(world, dem::kBack, wall);
  world.dt = 1e-6;  // short, so that the sphere has not spun up yet
  const int body = add_sphere(world, {kCentre[0], wall - kRadius + kOverlap, kCentre[2]}, kRadius);
  world.walls[dem::kPlate].velocity = -5;
  dem::compute_forces(world);
  run(world, 20);
  const double normal = world.walls[dem::kPlate].force;
  EXPECT_NEAR(normal, kStiffness * kOverlap, 1e-3);
  EXPECT_NEAR(world.walls.plate.force[2], kMu * normal, 1e-12) << "upward on a plate that goes down";
  EXPECT_LT(velocity(world, body)[2], 0);
}

/// The energy of elastic springs and of motion is what the plate put in, friction's loss aside.
TEST(PlateWork, IsTheEnergyGainedByAnElasticSwarmThatItStirs) {
  World world = swarm({.clusters = 60, .seed = 4, .speed = 0.05, .friction = 0, .damping = 0});
  world.walls.plate = {.x = 0.02, .y = 0.02, .half = {0.008, 0.002, 0.03}};
  world.walls[dem::kPlate] = {.present = true, .position = 0.085, .velocity = -0.5};
  world.walls[dem::kTop].present = false;
  world.dt *= 0.1;
  dem::compute_forces(world);
  const double before = dem::energies(world).total();
  while (world.walls[dem::kPlate].position > 0.045) run(world, 100);
  const double gained = dem::energies(world).total() - before;
  EXPECT_GT(gained, 2 * before) << "hardly any contacts";
  EXPECT_NEAR(world.wall_work / gained, 1, 1e-3);
}

}  // namespace
}  // namespace regolab::test
