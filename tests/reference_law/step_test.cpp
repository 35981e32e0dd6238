/// Whole steps beside their plain twin: a heap that slides off the end of its floor, a plate in it, every contact and every cluster, with each width
/// of the hot loops that the processor has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reference_law/plain_step.h"
#include "support/packing.h"
#include "support/simd_levels.h"

namespace regolab::test {
namespace {

constexpr double kStiffness = 1e4, kFriction = 0.4;

/// A plate over the heap that went down into it.
void push_in_plate(World& world) {
  world.walls.plate = {.x = 0.012, .y = 0.02, .half = {0.006, 0.002, 0.02}};
  world.walls[dem::kPlate] = {.present = true, .position = 0.06, .velocity = -4, .friction = 0.3};
  world.lists_stale = true;
  while (world.walls[dem::kPlate].position > 0.024) run(world, 10);
  world.walls[dem::kPlate].velocity = -0.3;
}

/// A swarm that fell (fast: heavy gravity saves steps), and then half of its floor goes, a wall closes in and one cluster is held.
World heap(const PlainLaw& law) {
  World world = swarm({.clusters = 120, .seed = 8, .speed = 0.3, .friction = kFriction, .damping = 0.3, .gravity = 500});
  world.law = engine_law(law, kFriction);
  world.dt = dem::stable_step(world, 0.1);
  run(world, 12000);
  push_in_plate(world);
  world.walls.floor_end = 0.02;
  world.walls[dem::kFront].velocity = 0.5;
  world.walls[dem::kRight].friction = 0;
  world.bodies.hold_fixed(3);
  world.lists_stale = true;
  run(world, 50);
  return world;
}

/// Largest differences seen, and what was seen.
struct Comparison {
  double force = 0, spring = 0, geometry = 0;  ///< [N], [m], [m] and of the unit normal
  double load = 0, torque = 0;                 ///< [N], [N m]
  double wall = 0;                             ///< [N]
  int missing = 0, wrong_counts = 0;
  int pairs = 0, walls = 0, edges = 0, at_plate = 0, plate_edges = 0, sliding = 0, sticking = 0, would_pull = 0, capped = 0, with_spring = 0;
};

void raise(double& most, double value) { most = std::max(most, std::isfinite(value) ? value : 1e300); }

constexpr double kBarely = 1e-15;  // [m] of overlap: whether such contacts touch is round-off

void compare(const std::vector<dem::Contact>& fast, bool walls, const std::map<Pair, PlainContact>& plain, Comparison& seen) {
  std::size_t matched = 0;
  for (const dem::Contact& c : fast) {
    const auto found = plain.find(walls ? Pair{c.body_b, c.sphere_a} : Pair{c.sphere_a, c.sphere_b});
    if (found == plain.end()) {
      seen.missing += c.overlap > kBarely;
      continue;
    }
    ++matched;
    const PlainContact& p = found->second;
    raise(seen.force, norm(c.force - p.answer.force));
    raise(seen.spring, norm(c.spring - p.answer.spring));
    raise(seen.geometry, norm(c.normal - p.normal));
    raise(seen.geometry, std::abs(c.overlap - p.overlap));
    raise(seen.geometry, norm(c.arm_a - p.arm_a));
    if (!walls) raise(seen.geometry, norm(c.arm_b - p.arm_b));
  }
  std::size_t plainly = 0;
  for (const auto& [pair, p] : plain) {
    plainly += p.overlap > kBarely;
    ++(walls ? seen.walls : seen.pairs);
    const bool plate = walls && pair.first == dem::kPlate;
    seen.at_plate += plate;
    seen.plate_edges += plate && p.at_edge;
    seen.edges += !plate && p.at_edge;
    ++(p.answer.slides ? seen.sliding : seen.sticking);
    seen.would_pull += p.answer.would_pull;
    seen.capped += p.answer.capped;
  }
  if (matched < plainly) seen.missing += static_cast<int>(plainly - matched);
}

void compare(const World& world, const PlainForces& plain, Comparison& seen) {
  compare(dem::contacts(world), false, plain.pairs, seen);
  compare(dem::wall_contacts(world), true, plain.walls, seen);
  for (std::size_t i = 0; i < plain.force.size(); ++i) {
    const dem::Load& on = world.bodies.load[i];
    const Vec3 force{on.fx, on.fy, on.fz}, about_origin{on.tx, on.ty, on.tz};
    raise(seen.load, norm(force - plain.force[i]));
    raise(seen.torque, norm(about_origin - cross(position(world, static_cast<int>(i)), force) - plain.torque[i]));
  }
  raise(seen.wall, norm(world.walls.plate.force - plain.on_plate));
  for (int id = 0; id < dem::kWallIds; ++id) {
    raise(seen.wall, std::abs(world.walls[id].force - plain.wall_force[id]));
    raise(seen.wall, std::abs(world.walls[id].shear - plain.wall_shear[id]));
    seen.wrong_counts += world.walls[id].contacts != plain.wall_contacts[id];
  }
}

struct Case {
  const char* name;
  PlainLaw law;
  bool caps;
};
/// The cap lies among the dashpots of the clusters, so that it cuts some of them; a fifth of critical or more makes leaving contacts
/// pull.
const Case kCases[] = {
    {"ratio", {kStiffness, 0.75 * kStiffness, 0.3, 0.2, true, 0}, false},
    {"absolute", {kStiffness, 0.75 * kStiffness, 0.1, 0.05, false, 0}, false},
    {"capped", {kStiffness, 0.75 * kStiffness, 0.3, 0.1, false, 0.1}, true},
};

void expect_close(const Comparison& seen) {
  EXPECT_EQ(seen.missing, 0);
  EXPECT_EQ(seen.wrong_counts, 0);
  EXPECT_LT(seen.geometry, 1e-13);
  EXPECT_LT(seen.force, 1e-12);
  EXPECT_LT(seen.spring, 1e-16);
  EXPECT_LT(seen.load, 2e-12) << "sums of several";
  EXPECT_LT(seen.torque, 1e-13) << "arms below a tenth of a metre";
  EXPECT_LT(seen.wall, 1e-11) << "sums of dozens";
}

void expect_enough(const Comparison& seen, bool caps) {
  EXPECT_GT(seen.pairs, 500);
  EXPECT_GT(seen.walls, 500);
  EXPECT_GT(seen.edges, 20);
  EXPECT_GT(seen.at_plate, 100);
  EXPECT_GT(seen.plate_edges, 5);
  EXPECT_GT(seen.sliding, 300);
  EXPECT_GT(seen.sticking, 300);
  EXPECT_GT(seen.would_pull, 10);
  EXPECT_GT(seen.with_spring, 1000);
  EXPECT_EQ(seen.capped > 100, caps);
}

std::string text_of(const Comparison& seen) {
  std::ostringstream text;
  text << "largest differences: force " << seen.force << " N, spring " << seen.spring << " m, geometry " << seen.geometry << ", load "
       << seen.load << " N, torque " << seen.torque << " N m, wall " << seen.wall << " N; pairs " << seen.pairs << ", at walls "
       << seen.walls << ", at the edge " << seen.edges << ", at the plate " << seen.at_plate << ", at its edges " << seen.plate_edges << ", sliding " << seen.sliding << ", sticking " << seen.sticking
       << ", would pull " << seen.would_pull << ", capped " << seen.capped;
  return text.str();
}

class Step : public testing::TestWithParam<Case> {};

/// Centres lie within 10 cm of the origin and are known to 1e-17 m or so, so overlaps too: 1e-13 N at 1e4 N/m. Normals of 2 mm contacts
/// are known to 1e-14. A right answer is thus right to 1e-12 N, of forces up to a newton; a wrong one is not.
TEST_P(Step, FollowsItsPlainTwin) {
  const Case& which = GetParam();
  const KeepSimd keep;
  const World start = heap(which.law);
  for (const dem::Simd level : simd_levels()) {
    ASSERT_TRUE(dem::set_simd(level));
    World world = start;
    Comparison seen;
    for (int look = 0; look < 40; ++look) {
      run(world, 24);
      const Springs before = springs_of(world);
      dem::step(world);
      compare(world, plain_forces(world, which.law, before), seen);
      seen.with_spring += static_cast<int>(before.pairs.size() + before.walls.size());
    }
    SCOPED_TRACE(std::string(name_of(level)) + ": " + text_of(seen));
    RecordProperty(name_of(level), text_of(seen));
    expect_close(seen);
    expect_enough(seen, which.caps);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, Step, testing::ValuesIn(kCases), [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace regolab::test
