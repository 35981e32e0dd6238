/// Bits with effects on: the same on any number of threads, with any width of the hot loops and any lists, and after a stop anywhere.
#include <gtest/gtest.h>

#include "support/packing.h"
#include "support/simd_levels.h"
#include "worker/dem/archive.h"

namespace regolab::test {
namespace {

World falling() {
  World world = swarm({.clusters = 61, .seed = 4, .gravity = 500});
  world.law.effects = {.rolling = 0.3, .cohesion = 2000, .hertz = 0.5, .hertz_overlap = 1e-5, .hertz_most = 25, .wall_compliance = 2};
  world.dt = dem::stable_step(world, 0.15);
  world.slabs = 8;
  return world;
}

World heap() {
  World world = falling();
  run(world, 24000);
  EXPECT_GT(dem::contacts(world).size(), 30U) << "too little happens";
  EXPECT_GT(world.near_pairs.rx.size(), 0U);
  return world;
}

std::string bits_after(World world, int steps) {
  run(world, steps);
  return state_bytes(world);
}

TEST(EffectBits, DoNotDependOnThreadsOrTheWidthOfTheLoops) {
  const KeepSimd keep;
  ASSERT_TRUE(dem::set_simd(dem::Simd::kPortable));
  const World start = heap();
  const std::string portable = bits_after(start, 500);
  for (const dem::Simd level : simd_levels()) {
    ASSERT_TRUE(dem::set_simd(level));
    for (const int threads : {1, 2}) {
      World world = start;
      world.threads = threads;
      EXPECT_TRUE(bits_after(world, 500) == portable) << name_of(level) << ", " << threads << " threads";
    }
  }
}

TEST(EffectBits, DoNotDependOnTheSkinOfTheLists) {
  World thin = falling(), thick = thin;
  thin.skin *= 0.3;
  run(thin, 12000);
  run(thick, 12000);
  EXPECT_NE(thin.list_builds, thick.list_builds);
  thin.skin = thick.skin;
  EXPECT_TRUE(state_bytes(thin) == state_bytes(thick));
}

TEST(EffectBits, GoOnAfterASaveAsIfItHadNotBeen) {
  World whole = heap();
  const std::string bytes = state_bytes(whole);
  World loaded;
  loaded.slabs = 8;
  dem::Loader loader(bytes);
  loaded.archive(loader);
  ASSERT_TRUE(loader.finished());
  EXPECT_EQ(loaded.law.effects.rolling, 0.3);
  EXPECT_TRUE(bits_after(loaded, 1000) == bits_after(whole, 1000));
}

TEST(EffectBits, OfALawWithoutAnyAreThoseOfThePlainLaw) {
  World plain = swarm({.clusters = 40, .seed = 2, .gravity = 50}), off = plain;
  off.law.effects = {.hertz_overlap = 1e-5, .hertz_most = 25, .iwashita_oda = true, .jkr = true};  // strengths 0
  off.dt = plain.dt;
  EXPECT_TRUE(bits_after(plain, 2000) == bits_after(off, 2000));
}

}  // namespace
}  // namespace regolab::test
