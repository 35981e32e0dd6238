/// Times our step on one bed of bench_beds and prints one line of key=value.
///   bench_step BED.csv [--steps N] [--threads T] [--skin M]
#include "worker/dem/step.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "support/grain_bed.h"
#include "worker/bench/bed.h"
#include "worker/bench/timing.h"
#include "worker/dem/watch.h"

namespace {

using namespace regolab;

constexpr int kWarmUp = 200;
constexpr double kDensity = 2930;  // [kg/m3]

struct Wish {
  std::string bed;
  int steps = 10000, threads = 1;
  double skin = 0;  // of the near lists [m]; 0 = as the protocols have it
};

/// Starts with relaxed springs, as LAMMPS does from its data file.
dem::World world_of(const test::GrainBed& bed, const Wish& wish) {
  dem::World world;
  test::add_grains(bed, kDensity, world);
  bench::furnish(bed.length, bed.width, world);
  world.threads = wish.threads;
  if (wish.skin > 0) world.skin = wish.skin;
  dem::compute_forces(world);
  return world;
}

int run(const Wish& wish) {
  std::ostringstream text;
  text << std::ifstream(wish.bed).rdbuf();
  const auto bed = test::from_csv(text.str());
  if (!bed) {
    std::fprintf(stderr, "bench_step: %s: %s\n", wish.bed.c_str(), bed.error().text.c_str());
    return 1;
  }
  dem::World world = world_of(*bed, wish);
  const auto builds_before = world.list_builds, refreshes_before = world.refreshes;
  const bench::StepCost cost = bench::time_steps(kWarmUp, wish.steps, world);
  const bench::TouchCount touching = bench::touches(world);
  std::printf(
      "clusters=%d spheres=%d steps=%d threads=%d wall_us=%.3f cpu_us=%.3f contacts=%ld wall_contacts=%ld kinetic_J=%.9g "
      "near_pairs=%zu near_walls=%zu refreshes=%lld list_builds=%lld\n",
      world.bodies.count(), world.spheres.count(), wish.steps, wish.threads, cost.wall_us, cost.cpu_us, touching.grains,
      touching.walls, dem::energies(world).kinetic, world.near_pairs.count, world.near_walls.count,
      static_cast<long long>(world.refreshes - refreshes_before), static_cast<long long>(world.list_builds - builds_before));
  return dem::finite(world) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"us per step of the engine on one bed"};
  Wish wish;
  app.add_option("bed", wish.bed, "BED.csv, made by bench_beds")->required()->check(CLI::ExistingFile);
  app.add_option("--steps", wish.steps, "timed, after 200 untimed ones")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--threads", wish.threads)->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--skin", wish.skin, "of the near lists [m]; 0 = as the protocols have it")->check(CLI::NonNegativeNumber);
  CLI11_PARSE(app, argc, argv);
  return run(wish);
}
