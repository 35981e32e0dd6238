/// A made-up world whose laws are known, its bank, its emulator, and measurements made in it.
#pragma once
#include <cmath>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {

inline double golden(int k, double step) { return std::fmod(0.5 + step * k, 1.0); }

/// A made-up world: density and slope answer to friction, density to N_E; cohesion steepens slopes, a grain density shows in the balance.
/// Two seeds a material; 60 materials without effects, 24 with each.
struct MadeUpWorld {
  Bank bank{.inputs = {{"theta_F", "rad"}, {"N_E", "1"}, {"cohesion", "Pa"}, {"grain_density", "1"}}, .features = {"contacts_per_particle", "bulk_density", "repose_angle"}, .rows = {}};

  static std::vector<double> measure(double friction, double elements, double cohesion, double density, int dither) {
    const auto noise = [&](int k) { return std::sin(1e4 * friction + 77.0 * dither + 13.0 * k); };
    return {4 - 2 * friction + 0.02 * noise(1), (1700 - 200 * friction - 20 * elements) * (1 + density) + 3 * noise(2),
            0.4 + 0.3 * friction + 0.15 * std::log1p(cohesion / 600) + 0.02 * noise(3)};
  }
  void add(int point, int seed, double cohesion, double density) {
    const double friction = golden(point, 0.7549), elements = 2.0 * (1 + point % 3);
    bank.rows.push_back({.experiment = cohesion != 0 ? "c" : density != 0 ? "d" : "n", .point = point, .seed = static_cast<std::uint64_t>(seed), .profile = "quick",
                         .inputs = {friction, elements, cohesion, density}, .features = measure(friction, elements, cohesion, density, 100 * point + seed)});
  }
  MadeUpWorld() {
    for (int point = 1; point <= 60; ++point) add(point, 1, 0, 0), add(point, 2, 0, 0);
    for (int k = 1; k <= 24; ++k) add(2 * k, 1, 20 * std::pow(1000.0, golden(k, 0.618)), 0), add(2 * k + 1, 1, 0, -0.05 + 0.1 * golden(k, 0.618));
  }
};

inline const Emulator& made_up_emulator() {
  static const MadeUpWorld world;
  static const auto made = Emulator::from(world.bank);
  return *made;
}

/// Three specimens of a material, measured.
inline ObservationSet measured_in_made_up_world(double friction, double elements, double cohesion, double density) {
  ObservationSet set;
  set.specimen.particles = 300;
  const char* ids[] = {"contacts_per_particle", "bulk_density", "repose_angle"};
  const char* units[] = {"1", "kg/m3", "rad"};
  for (int j = 0; j < 3; ++j) {
    double mean = 0;
    for (int seed = 0; seed < 3; ++seed) mean += MadeUpWorld::measure(friction, elements, cohesion, density, 9000 + seed)[static_cast<std::size_t>(j)] / 3;
    set.scalars.push_back({.id = ids[j], .value = mean, .unit = units[j], .unit_as_read = units[j], .standard_error = std::sqrt(made_up_emulator().noise()[j] / 3), .seeds = 3, .definition = {}});
  }
  return set;
}

/// A bank of density and sigma1 at two stresses; gravity and the grains' density never vary.
inline const Emulator& strength_emulator() {
  static const auto made = [] {
    Bank bank{.inputs = {{"theta_F", "rad"}, {"gravity", "m/s2"}, {"particle_density", "kg/m3"}}, .features = {"bulk_density", "sigma1_ratio_1.25", "sigma1_ratio_10"}, .rows = {}};
    for (int k = 0; k < 60; ++k) {
      const double friction = golden(k / 2, 0.618), common = 0.05 * std::sin(77.0 * k);
      bank.rows.push_back({.experiment = "n", .point = k / 2, .seed = static_cast<std::uint64_t>(k % 2), .profile = "quick", .inputs = {friction, 1.63, 2930},
                           .features = {1600 - 50 * friction + 20 * common, 0.7 + friction + common, 0.7 + friction + common + 0.02 * std::cos(13.0 * k)}});
    }
    return Emulator::from(bank);
  }();
  return *made;
}

}  // namespace regolab::gap
