#include "scheduler/gap/candidate_tests.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

/// Tests that one specimen answers.
enum class Sort { kDensity, kFabric, kRepose, kStress, kPenetration };

/// Hours of one specimen, preparation included. Assumed: what a technician at a bench takes, not read anywhere.
constexpr double kHours[] = {0.25, 4, 0.5, 3, 1};

struct Setup {
  Sort sort;
  double sigma3;
  auto operator<=>(const Setup&) const = default;
};

Setup setup_of(const FeatureInfo& f) {
  switch (f.group.test) {
    case Test::kSettle: return {f.id.ends_with("_per_particle") ? Sort::kFabric : Sort::kDensity, 0};
    case Test::kRepose: return {Sort::kRepose, 0};
    case Test::kStress: return {Sort::kStress, f.group.sigma3};
    case Test::kPenetration: return {Sort::kPenetration, 0};
  }
  return {Sort::kDensity, 0};
}

std::string name_of(const Setup& setup) {
  switch (setup.sort) {
    case Sort::kDensity: return "density of the poured bed";
    case Sort::kFabric: return "contacts per particle (tomography)";
    case Sort::kRepose: return "angle of repose";
    case Sort::kStress: return "stress test at " + kilopascals(setup.sigma3) + " kPa";
    case Sort::kPenetration: return "penetration";
  }
  return "";
}

double hours_of(const Setup& setup, int specimens) { return specimens * kHours[static_cast<int>(setup.sort)]; }

// Design, section 2.11: what measures a cause itself rather than what comes of it.
constexpr OtherTest kOthers[] = {
    {"one stress test at two loading speeds", "cohesion", "loading_rate", 3},
    {"one stress test at two loading speeds", "lateral_stress_offset", "loading_rate", 3},
    {"blank test of the frame with a steel dummy", "apparatus", "", 2},
    {"sieving a specimen after the stress test", "breakage", "", 1},
    {"repose between walls of two distances", "wall_friction", "rolling_resistance", 1},
    {"sieving the material before the tests", "size_distribution", "", 1},
    {"weighing grains in a pycnometer", "grain_density", "", 1},
    {"unloading and reloading within a stress test", "boundary_compliance", "hertzian_contact", 1},
    {"pressure on the side walls measured in the stress test", "lateral_stress_offset", "cohesion", 2},
    {"the same material rained from another height, or tapped", "preparation", "size_distribution", 1},
};

}  // namespace

std::vector<CandidateTest> candidate_tests(const Emulator& emulator, const Comparison& comparison, int specimens, double size_ratio) {
  std::map<Setup, CandidateTest> fresh, more;
  for (std::size_t f = 0; f < emulator.features().size(); ++f) {
    const FeatureInfo& info = emulator.features()[f];
    const Setup setup = setup_of(info);
    const auto measured = std::ranges::find(comparison.feature, static_cast<Eigen::Index>(f));
    if (measured == comparison.feature.end()) {
      CandidateTest& test = fresh[setup];
      test.hours = hours_of(setup, specimens);
      const double error = std::sqrt(emulator.noise()[static_cast<Eigen::Index>(f)] * size_ratio / specimens);
      test.features.push_back({.id = info.id, .group = info.group, .standard_error = error, .repeats = specimens});
    } else {
      CandidateTest& test = more[setup];
      Feature feature = comparison.measured[static_cast<std::size_t>(measured - comparison.feature.begin())];
      const int added = 3 * std::max(1, feature.repeats);
      test.hours = std::max(test.hours, hours_of(setup, added));
      test.name = std::to_string(added) + " more specimens: " + name_of(setup);
      test.repeated = true;
      test.features.push_back(std::move(feature));
    }
  }
  std::vector<CandidateTest> out;
  for (auto& [setup, test] : fresh) {
    test.name = name_of(setup) + (more.contains(setup) ? ", what is missing of it" : "");
    out.push_back(std::move(test));
  }
  for (auto& [setup, test] : more) out.push_back(std::move(test));
  return out;
}

std::span<const OtherTest> other_tests() { return kOthers; }

}  // namespace regolab::gap
