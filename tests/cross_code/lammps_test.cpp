/// The engine beside LAMMPS, on the same bed under the same law: trajectories through the first contacts, and what a settled
/// bed looks like. The two laws differ in two known points:
///  - LAMMPS takes the tangential velocity at the spheres' full radii, we at the middle of the overlap: a share overlap /
///  2r;
///  - while a contact slides, LAMMPS takes the tangential dashpot's share out of the spring, we switch that dashpot off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "cross_code/lammps_run.h"
#include "support/packing.h"
#include "support/small_world.h"
#include "support/temp_dir.h"
#include "worker/bench/bed.h"

namespace regolab::test {
namespace {

#define SKIP_WITHOUT_LAMMPS() \
  if (!lammps_is_installed()) GTEST_SKIP() << "LAMMPS is not installed (no lmp in PATH): apt-get install lammps"

struct Both {
  std::vector<State> ours, theirs;
};

Both run_both(const GrainBed& start, const Setting& setting) {
  const TempDir directory;
  auto theirs = run_lammps(start, setting, directory / "");
  EXPECT_TRUE(theirs.ok()) << theirs.error().text;
  if (!theirs) return {};
  return {run_ours(start, setting), std::move(*theirs)};
}

// --- the bed itself, with or without LAMMPS

TEST(BesideLammps, ABedSurvivesItsCsvToTheBit) {
  const GrainBed bed = grains_of(swarm({.clusters = 10, .seed = 1, .speed = 0.1}));
  const auto read = from_csv(to_csv(bed));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(to_csv(*read), to_csv(bed));
  EXPECT_FALSE(from_csv(to_csv(bed).substr(0, 40)).ok());
}

TEST(BesideLammps, AMirroredNeighbourMovesAsTheMirrorImage) {
  const GrainBed bed = grains_of(swarm({.clusters = 10, .seed = 1, .speed = 0.1}));
  const GrainBed four = tiled(bed, 2, 2);
  ASSERT_EQ(four.grains.size(), 40u);
  const Grain &original = four.grains[3], &in_y = four.grains[13], &in_x = four.grains[23];
  EXPECT_DOUBLE_EQ(original.centre[0][0] + in_x.centre[0][0], 2 * bed.length);
  EXPECT_DOUBLE_EQ(original.centre[0][1] + in_y.centre[0][1], 2 * bed.width);
  EXPECT_EQ(in_x.velocity, (Vec3{-original.velocity[0], original.velocity[1], original.velocity[2]}));
  EXPECT_EQ(in_x.spin, (Vec3{original.spin[0], -original.spin[1], -original.spin[2]}));
}

// --- trajectories

constexpr double kSpeed = 0.1;      // largest, of each component [m/s]
constexpr double kStretch = 20e-3;  // [s]

/// 60 clusters of all kinds, flying and spinning through a box of 4 x 4 cm; 15 or more of them meet something within kStretch.
GrainBed flying_grains() { return grains_of(swarm({.clusters = 60, .seed = 3, .speed = kSpeed})); }

Setting flight(double friction, double tangential_damping) {
  Setting setting{.law = {.normal_stiffness = 7.5e4,
                          .normal_damping = 0.1,
                          .tangential_stiffness = 5e4,
                          .tangential_damping = tangential_damping,
                          .friction = friction},
                  .side_friction = friction,
                  .gravity = 1.63,
                  .dt = 2e-7};
  setting.steps = std::lround(kStretch / setting.dt);
  setting.every = setting.steps / 20;
  return setting;
}

struct Apart {
  double place = 0;     ///< farthest apart of any sphere [m]
  double velocity = 0;  ///< of any cluster [m/s]
};

Apart apart(const Grain& a, const Grain& b) {
  Apart out{.velocity = norm(a.velocity - b.velocity)};
  for (std::size_t i = 0; i < a.centre.size(); ++i) out.place = std::max(out.place, norm(a.centre[i] - b.centre[i]));
  return out;
}

bool flew_freely(const Grain& start, const Grain& now, double gravity, double time) {
  return norm(now.velocity - (start.velocity + Vec3{0, 0, -gravity * time})) < 1e-9;
}

/// Until the first contact only rounding differs. A contact lasts pi sqrt(m/K), so with dt = 2e-7 s each code sees its ends
/// to a few per cent of the smallest clusters' oscillation time 1 / sqrt(K/m) = 6e-6 s, and the overlap of up to v sqrt(m/K)
/// = 1e-6 m is 2 to 3 parts in 1000 of a small sphere's diameter: up to 0.5 % of the velocity a contact. 1e-3 m/s is 0.6 %
/// of the fastest cluster's speed; kept for kStretch it is 2e-5 m. Measured: five per cent
/// more friction, or ten per cent more of a spring or a dashpot, shows as 4e-3 m/s or more.
void expect_same_flight(const Setting& setting) {
  const GrainBed start = flying_grains();
  const Both both = run_both(start, setting);
  ASSERT_EQ(both.ours.size(), both.theirs.size());
  std::size_t touched = 0;
  for (std::size_t k = 0; k < both.ours.size(); ++k) {
    const State &ours = both.ours[k], &theirs = both.theirs[k];
    touched = 0;
    for (std::size_t g = 0; g < start.grains.size(); ++g) {
      const Apart found = apart(ours.bed.grains[g], theirs.bed.grains[g]);
      const bool is_free = flew_freely(start.grains[g], ours.bed.grains[g], setting.gravity, ours.time);
      touched += is_free ? 0 : 1;
      EXPECT_LT(found.place, is_free ? 1e-11 : 2e-5) << "cluster " << g << " at " << ours.time << " s";
      EXPECT_LT(found.velocity, is_free ? 1e-11 : 1e-3) << "cluster " << g << " at " << ours.time << " s";
    }
  }
  EXPECT_GE(touched, 15u) << "too few contacts to compare";
}

TEST(BesideLammps, TheSameFlightThroughContactsThatSlide) {
  SKIP_WITHOUT_LAMMPS();
  expect_same_flight(flight(0.5, 0));  // no tangential dashpot, in which sliding contacts differ
}

TEST(BesideLammps, TheSameFlightThroughContactsThatStick) {
  SKIP_WITHOUT_LAMMPS();
  expect_same_flight(flight(50, 0.1));  // friction that never lets slide, and the dashpot on
}

// --- a settled bed

constexpr int kSeeds = 6;

/// Strong gravity and soft springs bring the bed to rest within 0.2 s. Smooth side walls: the floor carries all the weight.
Setting settling() {
  return {.law = {.normal_stiffness = 2e4,
                  .normal_damping = 0.05,
                  .tangential_stiffness = 2e4,
                  .tangential_damping = 0.05,
                  .friction = 0.5},
          .gravity = 40,
          .dt = 3e-6,
          .steps = 66000,
          .every = 3300};
}

/// [kSeeds] each.
struct Settled {
  std::vector<double> height, contacts, floor_share;
};

double volume_of(const Grain& grain) {
  double volume = 0;
  for (const double r : grain.radius) volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  return volume;
}

/// Of the centre of mass of all: potential energy over weight [m].
double mean_height(const GrainBed& bed) {
  double moment = 0, volume = 0;
  for (const Grain& grain : bed.grains) {
    for (std::size_t i = 0; i < grain.radius.size(); ++i) moment += std::pow(grain.radius[i], 3) * grain.centre[i][2];
    for (const double r : grain.radius) volume += std::pow(r, 3);
  }
  return moment / volume;
}

double contacts_per_cluster(const GrainBed& bed) {
  int sides = 0;
  for (const Grain& a : bed.grains) {
    for (const Grain& b : bed.grains) {
      if (&a == &b) continue;
      for (std::size_t i = 0; i < a.radius.size(); ++i) {
        for (std::size_t j = 0; j < b.radius.size(); ++j) {
          sides += norm(a.centre[i] - b.centre[j]) < a.radius[i] + b.radius[j] ? 1 : 0;
        }
      }
    }
  }
  return sides / static_cast<double>(bed.grains.size());
}

/// Means over the last states: contacts flicker.
void note(const std::vector<State>& states, double gravity, Settled& settled) {
  constexpr std::size_t kLast = 4;
  double height = 0, contacts = 0, force = 0, weight = 0;
  for (std::size_t k = states.size() - kLast; k < states.size(); ++k) {
    height += mean_height(states[k].bed) / kLast;
    contacts += contacts_per_cluster(states[k].bed) / kLast;
    force += states[k].floor_force / kLast;
  }
  for (const Grain& grain : states.back().bed.grains) weight += 2930 * gravity * volume_of(grain);
  settled.height.push_back(height);
  settled.contacts.push_back(contacts);
  settled.floor_share.push_back(force / weight);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
double squares_about_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += (value - mean(values)) * (value - mean(values));
  return sum;
}

/// Four standard errors of the difference, from the scatter of both between seeds (2 (n - 1) = 10 degrees of freedom): by
/// chance once in 400 times.
double allowed(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  return 4 * std::sqrt((squares_about_mean(a) + squares_about_mean(b)) / (2 * (n - 1)) * 2 / n);
}

TEST(BesideLammps, TheSameBedOnAverage) {
  SKIP_WITHOUT_LAMMPS();
  const Setting setting = settling();
  Settled ours, theirs;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const auto cloud =
        bench::cloud({.clusters = 100, .spheres_each = 6, .width = 0.02, .seed = static_cast<std::uint64_t>(seed)});
    ASSERT_TRUE(cloud.has_value());
    const GrainBed start = grains_of(*cloud);
    const Both both = run_both(start, setting);
    ASSERT_FALSE(both.theirs.empty());
    note(both.ours, setting.gravity, ours);
    note(both.theirs, setting.gravity, theirs);
  }
  EXPECT_NEAR(mean(ours.height), mean(theirs.height), allowed(ours.height, theirs.height));
  EXPECT_NEAR(mean(ours.contacts), mean(theirs.contacts), allowed(ours.contacts, theirs.contacts));
  EXPECT_LT(allowed(ours.height, theirs.height), 0.05 * mean(ours.height)) << "too much scatter to tell";
  EXPECT_LT(allowed(ours.contacts, theirs.contacts), 0.15 * mean(ours.contacts)) << "too much scatter to tell";
  for (std::size_t k = 0; k < ours.height.size(); ++k) {
    EXPECT_NEAR(ours.floor_share[k], 1, 0.01) << "ours, seed " << k + 1;
    EXPECT_NEAR(theirs.floor_share[k], 1, 0.01) << "LAMMPS, seed " << k + 1;
  }
  RecordProperty("height_mm", std::to_string(1e3 * mean(ours.height)) + " / " + std::to_string(1e3 * mean(theirs.height)));
}

}  // namespace
}  // namespace regolab::test
