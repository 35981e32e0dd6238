/// Bits: the same on any number of threads, whatever the skin of the lists, and after a stop anywhere.
#include <gtest/gtest.h>

#include "support/packing.h"
#include "worker/dem/archive.h"
#include "worker/generate/random.h"

namespace regolab::test {
namespace {

World falling_swarm() { return swarm({.clusters = 60, .seed = 4, .speed = 0.3, .gravity = 1.63}); }

TEST(Determinism, OneTwoAndThreeThreadsGiveTheSameBits) {
  World one = falling_swarm();
  run(one, 3000);
  for (const int threads : {2, 3}) {
    World many = falling_swarm();
    many.threads = threads;
    run(many, 3000);
    EXPECT_EQ(state_bytes(many), state_bytes(one)) << threads << " threads";
  }
}

TEST(Determinism, TheSkinOfTheListsDoesNotShow) {
  World thin = falling_swarm(), thick = falling_swarm();
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
  run(whole, 4000);
  const generate::Random random(99);
  World now = falling_swarm();
  for (std::uint64_t cut = 0; now.step < 4000; ++cut) {
    const auto steps = static_cast<int>(1 + 600 * random.uniform(generate::Purpose::kWitness, cut));
    run(now, std::min(steps, static_cast<int>(4000 - now.step)));
    const std::string bytes = state_bytes(now);
    World loaded;
    dem::Loader loader(bytes);
    loaded.archive(loader);
    ASSERT_TRUE(loader.finished());
    now = std::move(loaded);
  }
  EXPECT_EQ(state_bytes(now), state_bytes(whole));
}

TEST(Determinism, ASavedWorldCutShortIsNoticed) {
  World world = falling_swarm();
  run(world, 10);
  const std::string bytes = state_bytes(world);
  for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{9}, std::size_t{0}}) {
    World loaded;
    dem::Loader loader(std::string_view(bytes).substr(0, size));
    loaded.archive(loader);
    EXPECT_FALSE(loader.finished()) << size;
  }
}

}  // namespace
}  // namespace regolab::test
