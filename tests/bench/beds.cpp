/// Makes the beds that tests/bench/peers.sh times, those that are not there yet: NAME.csv for us, NAME.data for LAMMPS.
///   bench_beds DIR
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/grain_bed.h"
#include "worker/bench/bed.h"
#include "worker/dem/step.h"

namespace regolab::test {
namespace {

namespace fs = std::filesystem;

constexpr double kDensity = 2930;        // [kg/m3]
constexpr int kFallSteps = 100000;       // 0.2 s at kFastStep: half way down
constexpr double kHeadroomShare = 0.02;  // of the bed's height; small, for LAMMPS bins the empty space too
constexpr double kHeadroom = 0.002;      // [m]

[[noreturn]] void fail(const std::string& text) {
  std::fprintf(stderr, "bench_beds: %s\n", text.c_str());
  std::exit(1);
}

/// Whole or not there.
void write(const fs::path& path, const std::string& text) {
  const fs::path beside = path.string() + ".part";
  std::ofstream(beside, std::ios::binary) << text;
  std::error_code problem;
  if (fs::file_size(beside, problem) == text.size()) fs::rename(beside, path, problem);
  if (problem || !fs::exists(path)) fail(path.string() + " cannot be written (disk full, or no permission) free some space");
}

void store(const fs::path& directory, const std::string& name, const GrainBed& bed) {
  write(directory / (name + ".data"), to_lammps_data(bed, kDensity, kHeadroomShare * top_of(bed) + kHeadroom));
  write(directory / (name + ".csv"), to_csv(bed));  // last: the bed counts as made when it is there
}

GrainBed load(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  auto bed = from_csv(text.str());
  if (!bed) fail(path.string() + ": " + bed.error().text);
  return *bed;
}

/// A line that is rewritten while it works, and stays when done.
class Progress {
 public:
  explicit Progress(std::string name) : name_(std::move(name)) {}
  void show(double fraction) {
    const int percent = static_cast<int>(100 * fraction);
    if (percent / 5 == shown_ / 5) return;
    shown_ = percent;
    std::fprintf(stderr, "\rbed %s: %d %%  ", name_.c_str(), percent);
  }
  ~Progress() {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun_;
    std::fprintf(stderr, "\rbed %s: made in %.0f s\n", name_.c_str(), took.count());
  }

 private:
  std::string name_;
  int shown_ = -1;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

dem::World cloud_of(const bench::BedPlan& plan) {
  auto world = bench::cloud(plan);
  if (!world) fail("the parent spheres found no room (box too narrow) widen the box");
  return std::move(*world);
}

void make_settled(const fs::path& directory, const std::string& name, const bench::BedPlan& plan) {
  if (fs::exists(directory / (name + ".csv"))) return;
  Progress progress(name);
  dem::World world = cloud_of(plan);
  bench::settle(world, [&](double fraction) { progress.show(fraction); });
  store(directory, name, grains_of(world));
}

void make_falling(const fs::path& directory, const std::string& name, const bench::BedPlan& plan) {
  if (fs::exists(directory / (name + ".csv"))) return;
  Progress progress(name);
  dem::World world = cloud_of(plan);
  world.dt = bench::kFastStep;
  dem::compute_forces(world);
  bench::advance(kFallSteps, world, [&](double fraction) { progress.show(fraction); });
  store(directory, name, grains_of(world));
}

void make_all(const fs::path& directory) {
  make_settled(directory, "A", {.clusters = 1000, .spheres_each = 6, .width = 0.042});
  make_settled(directory, "B", {.clusters = 1000, .spheres_each = 2, .width = 0.042});
  make_settled(directory, "D1", {.clusters = 1000, .spheres_each = 1, .width = 0.064});
  make_falling(directory, "A_fall", {.clusters = 1000, .spheres_each = 6, .width = 0.042});
  if (!fs::exists(directory / "C.csv")) store(directory, "C", tiled(load(directory / "A.csv"), 4, 2));
}

}  // namespace
}  // namespace regolab::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: bench_beds DIR\n");
    return 2;
  }
  std::error_code problem;
  std::filesystem::create_directories(argv[1], problem);
  if (problem) {
    std::fprintf(stderr, "bench_beds: %s cannot be made (%s) choose another folder\n", argv[1], problem.message().c_str());
    return 1;
  }
  regolab::test::make_all(argv[1]);
}
