/// Time of each phase of a step, named as in worker/dem/step.h: bench_phases BED.csv [--benchmark_filter=press_pairs ...]. The world
/// really steps and one phase is timed, so that caches are as they are in a run. REGOLAB_SIMD=avx2|portable shows the other paths.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <vector>

#include "support/grain_bed.h"
#include "worker/bench/bed.h"
#include "worker/dem/step.h"

namespace {

using namespace regolab;

constexpr double kDensity = 2930;  // [kg/m3]
constexpr int kWarmUp = 200, kSteps = 4000;

struct Phase {
  const char* name;
  std::function<void(dem::World&)> run;
};

/// dem::step as a list, `refresh_lists` only when a cluster left its margin.
const std::vector<Phase>& phases() {
  static bool strayed = false;
  static const std::vector<Phase> list{
      {"kick_and_drift", [](dem::World& w) { strayed = dem::kick_and_drift(w); }},
      {"refresh_lists", [](dem::World& w) { if (strayed) dem::refresh_lists(w); }},
      {"place_balls", [](dem::World& w) { dem::place_balls(w); }},
      {"press_pairs", [](dem::World& w) { dem::press_pairs(w); }},
      {"press_walls", [](dem::World& w) { dem::press_walls(w); }},
      {"add_crossings", [](dem::World& w) { dem::add_crossings(w); }},
  };
  return list;
}

dem::World world_of(const test::GrainBed& bed, int threads) {
  dem::World world;
  test::add_grains(bed, kDensity, world);
  bench::furnish(bed.length, bed.width, world);
  world.threads = threads;
  dem::compute_forces(world);
  bench::advance(kWarmUp, world);
  return world;
}

/// A step with phases [first, last) timed; the whole step when that is all of them.
void time_phases(benchmark::State& state, const test::GrainBed& bed, std::size_t first, std::size_t last) {
  dem::World world = world_of(bed, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    std::chrono::duration<double> spent{};
    for (std::size_t k = 0; k < phases().size(); ++k) {
      const auto from = std::chrono::steady_clock::now();
      phases()[k].run(world);
      if (k >= first && k < last) spent += std::chrono::steady_clock::now() - from;
    }
    ++world.step;
    state.SetIterationTime(spent.count());
  }
  state.counters["near_pairs"] = static_cast<double>(world.near_pairs.count);
  state.counters["sphere_steps/s"] = benchmark::Counter(world.spheres.count(), benchmark::Counter::kIsIterationInvariantRate);
}

void enlist(const char* name, const test::GrainBed& bed, std::size_t first, std::size_t last) {
  benchmark::RegisterBenchmark(name, [&bed, first, last](benchmark::State& state) { time_phases(state, bed, first, last); })
      ->ArgName("threads")->Arg(1)->Arg(2)->UseManualTime()->Iterations(kSteps)->Unit(benchmark::kMicrosecond);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "bench_phases: no bed (one of build/bench/beds/*.csv) make them: build/tests/bench_beds build/bench/beds\n");
    return 2;
  }
  std::ostringstream text;
  text << std::ifstream(argv[1]).rdbuf();
  const auto bed = test::from_csv(text.str());
  if (!bed) {
    std::fprintf(stderr, "bench_phases: %s: %s\n", argv[1], bed.error().text.c_str());
    return 1;
  }
  for (std::size_t k = 0; k < phases().size(); ++k) enlist(phases()[k].name, *bed, k, k + 1);
  enlist("step", *bed, 0, phases().size());
  benchmark::RunSpecifiedBenchmarks();
}
