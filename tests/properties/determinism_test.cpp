/// Bits: the same on any number of threads, with any width of the hot loops, whatever the skin of the lists, and after a stop anywhere.
#include <gtest/gtest.h>

#include <limits>

#include <cmath>

#include "support/packing.h"
#include "support/simd_levels.h"
#include "worker/dem/archive.h"
#include "worker/generate/random.h"

namespace regolab::test {
namespace {

World falling_swarm() { return swarm({.clusters = 60, .seed = 4, .speed = 0.3, .gravity = 1.63}); }

/// 61 spheres, spinning, thrown into a corner: no multiple of any width.
World falling_spheres() {
  dem::LinearLaw law = elastic_law(1e4);
  law.friction = 0.4;
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * 0.3 * std::sqrt(law.normal_stiffness);
  World world = empty_world(law);
  for (int i = 0; i < 61; ++i) {
    const double x = 0.003 + 0.0055 * (i % 4), y = 0.003 + 0.0055 * (i / 4 % 4), z = 0.003 + 0.0055 * (i / 16);
    const int body = add_sphere(world, {x, y, z}, 0.0015 + 0.001 * (i % 7) / 7);
    set_velocity(world, body, {-1, -0.7, -1.3});
    set_spin(world, body, {100, -50, 10.0 * i});
  }
  for (const int wall : {dem::kLeft, dem::kFront, dem::kFloor}) add_wall(world, wall, 0, 0.4);
  world.gravity = 100;
  world.dt = dem::stable_step(world, 0.15);
  return world;
}

TEST(Determinism, OneTwoAndThreeThreadsGiveTheSameBits) {
  for (const std::size_t slabs : {0, 3, 8}) {  // 0: a small bed is not cut
    World one = falling_swarm();
    one.slabs = slabs;
    run(one, 1500);
    EXPECT_EQ(one.crossings.cell.empty(), slabs == 0) << "what crosses from slab to slab is to be tried";
    for (const int threads : {2, 3}) {
      World many = falling_swarm();
      many.slabs = slabs;
      many.threads = threads;
      run(many, 1500);
      EXPECT_EQ(state_bytes(many), state_bytes(one)) << threads << " threads, " << slabs << " slabs";
    }
  }
}

TEST(Determinism, MoreThreadsThanSlabsOnlyWait) {
  World one = falling_swarm(), many = falling_swarm();
  many.threads = dem::kSlabs + 1;
  one.slabs = many.slabs = dem::kSlabs;
  run(one, 100);
  run(many, 100);
  EXPECT_EQ(state_bytes(many), state_bytes(one));
}

/// Bytes after `steps`, with this width of the hot loops on so many threads.
std::string bits_of(World world, int steps, dem::Simd level, int threads) {
  EXPECT_TRUE(dem::set_simd(level));
  world.threads = threads;
  run(world, steps);
  EXPECT_GT(dem::contacts(world).size() + dem::wall_contacts(world).size(), 10U) << "too little happens";
  return state_bytes(world);
}

/// Threads wait for one another on a busy machine, so they get fewer steps.
TEST(Determinism, EveryWidthOfTheHotLoopsGivesThePortableBitsOnOneThreadAndTwoAgainAndAgain) {
  const KeepSimd keep;
  ASSERT_TRUE(dem::set_simd(dem::Simd::kPortable));
  World start = swarm({.clusters = 61, .seed = 4, .gravity = 500});  // heavy: a heap soon, full of contacts
  start.slabs = 8;
  run(start, 10000);
  const std::string portable = bits_of(start, 2000, dem::Simd::kPortable, 1), early = bits_of(start, 500, dem::Simd::kPortable, 1);
  for (const dem::Simd level : simd_levels()) {
    EXPECT_TRUE(bits_of(start, 2000, level, 1) == portable) << name_of(level);
    EXPECT_TRUE(bits_of(start, 2000, level, 1) == portable) << name_of(level) << ", again";
    EXPECT_TRUE(bits_of(start, 500, level, 2) == early) << name_of(level) << ", two threads";
  }
  EXPECT_TRUE(bits_of(start, 500, simd_levels().back(), 2) == early) << "two threads, again";
}

/// Clusters of one sphere take the short way through the integrator: spin without a turn.
TEST(Determinism, SingleSpheresToo) {
  const KeepSimd keep;
  const std::string portable = bits_of(falling_spheres(), 300, dem::Simd::kPortable, 1);
  for (const dem::Simd level : simd_levels()) {
    for (const int threads : {1, 2}) {
      EXPECT_TRUE(bits_of(falling_spheres(), 300, level, threads) == portable) << name_of(level) << ", " << threads << " threads";
    }
  }
}

TEST(Determinism, TheSkinOfTheListsDoesNotShow) {
  World thin = falling_swarm(), thick = falling_swarm();
  thin.slabs = thick.slabs = 8;
  thin.skin *= 0.3;
  thick.skin *= 2;
  run(thin, 3000);
  run(thick, 3000);
  EXPECT_NE(thin.list_builds, thick.list_builds);
  thin.skin = thick.skin;  // the only number that may differ
  EXPECT_EQ(state_bytes(thin), state_bytes(thick));
}

TEST(Determinism, SavedAndLoadedAtRandomStepsItGoesOnBitForBit) {
  World whole = falling_swarm();
  whole.slabs = 8;
  run(whole, 4000);
  const generate::Random random(99);
  World now = falling_swarm();
  now.slabs = 8;
  for (std::uint64_t cut = 0; now.step < 4000; ++cut) {
    const auto steps = static_cast<int>(1 + 600 * random.uniform(generate::Purpose::kWitness, cut));
    run(now, std::min(steps, static_cast<int>(4000 - now.step)));
    const std::string bytes = state_bytes(now);
    World loaded;
    loaded.slabs = 8;
    dem::Loader loader(bytes);
    loaded.archive(loader);
    ASSERT_TRUE(loader.finished());
    now = std::move(loaded);
  }
  EXPECT_EQ(state_bytes(now), state_bytes(whole));
}

TEST(Determinism, ThreadsMayComeAndGoBetweenSteps) {
  World steady = falling_swarm(), changing = falling_swarm();
  run(steady, 300);
  for (const int threads : {1, 2, 1}) {
    changing.threads = threads;
    run(changing, 100);
  }
  EXPECT_EQ(state_bytes(changing), state_bytes(steady));
}

TEST(Determinism, ARunThatBlewUpIsToldNotTheEndOfTheProgram) {
  World world = falling_swarm();
  run(world, 10);
  world.bodies.vx[3] = std::numeric_limits<double>::quiet_NaN();
  world.lists_stale = true;
  run(world, 10);
  EXPECT_FALSE(dem::finite(world));
}

TEST(Determinism, ASavedWorldCutShortIsNoticed) {
  World world = falling_swarm();
  run(world, 10);
  const std::string bytes = state_bytes(world);
  for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{9}, std::size_t{0}}) {
    World loaded;
    loaded.slabs = 8;
    dem::Loader loader(std::string_view(bytes).substr(0, size));
    loaded.archive(loader);
    EXPECT_FALSE(loader.finished()) << size;
  }
}

}  // namespace
}  // namespace regolab::test
