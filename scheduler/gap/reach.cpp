#include "scheduler/gap/reach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scheduler/gap/comparison.h"
#include "scheduler/gap/number_check.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

constexpr double kRounding = 0.005;  // of a range's end: 9.81 is 9.8
constexpr double kBeside = 0.03;     // of a range: points of a design stop short of its ends
constexpr double kSpread = 2;        // standard errors within which a stated value may still be the bank's
constexpr double kOtherBase = 0.05;  // share by which a base may differ
constexpr int kStagesAStress = 736;  // of the shipped bank: 192 materials with two seeds, 11 effects of 32 runs
constexpr int kStagesAMinute = 50;   // measured, 2 cores

/// Stated key and axis, where their names differ.
std::string axis_of(const std::string& key) { return key == "nominal_max_size" ? "L_S" : key; }

void check(const std::string& key, double value, double standard_error, const Space& space, std::string_view unit, Reach& reach) {
  const int at = space.find(axis_of(key));
  if (at < 0) return;
  const Axis& axis = space.axes[static_cast<std::size_t>(at)];
  if (axis.is_choice()) {
    if (std::ranges::find(axis.choices, value) == axis.choices.end()) reach.refused.push_back({key, key + " is none that the bank has (its runs know others alone) leave it out, to have it integrated out"});
    return;
  }
  const double rounding = std::max(kRounding * std::max(std::abs(axis.low), std::abs(axis.high)), kBeside * (axis.high - axis.low)), spread = std::max(rounding, kSpread * standard_error);
  if (value >= axis.low - spread && value <= axis.high + spread) return;
  reach.refused.push_back({key, key + " of " + shown(value, unit) + " is outside the bank (its runs go from " + shown(axis.low, unit) + " to " + shown(axis.high, unit) +
                                    ") leave it out, to have it integrated out over them, or make a bank of your own: bash scheduler/gap/bank/run.sh"});
}

void check_material(const ObservationSet& set, const Space& space, Reach& reach) {
  if (set.material.nominal_max_size) check("nominal_max_size", *set.material.nominal_max_size, 0, space, "m", reach);
  if (set.protocol.gravity) check("gravity", *set.protocol.gravity, 0, space, "m/s2", reach);
  for (const auto& [name, known] : set.material.micro) check(name, known.value, known.standard_error.value_or(0), space, known.unit, reach);
}

std::string levels_of(const Emulator& emulator) {
  std::set<double> levels;
  for (const FeatureInfo& f : emulator.features()) {
    if (f.group.test == Test::kStress && f.group.sigma3 > 0) levels.insert(f.group.sigma3);
  }
  std::string text;
  for (const double level : levels) text += (text.empty() ? "" : ", ") + kilopascals(level);
  return text;
}

/// What running the bank under one more stress takes.
std::string cost() {
  return "about " + std::to_string(kStagesAStress / kStagesAMinute) + " min on 2 cores where the bank's beds are stored, 2 to 3 h where they are not; it resumes";
}

void check_features(const Emulator& emulator, const ObservationSet& set, Reach& reach) {
  std::map<double, int> stresses;
  for (const Feature& f : features_of(readings_of(set))) {
    if (emulator.feature(f.id) >= 0 || f.group.test == Test::kPenetration) continue;
    if (f.group.sigma3 > 0) ++stresses[f.group.sigma3];
  }
  const std::string has = levels_of(emulator);
  for (const auto& [sigma3, count] : stresses) {
    const bool known = (", " + has + ",").find(", " + kilopascals(sigma3) + ",") != std::string::npos;
    if (known || has.empty()) continue;
    std::string all = has;
    std::erase(all, ',');
    reach.left_out.push_back({"stress at " + kilopascals(sigma3) + " kPa", std::to_string(count) + (count == 1 ? " feature" : " features") + " (the bank has " + has +
                              " kPa) run it there, then diagnose with --bank: bash scheduler/gap/bank/run.sh --sigma3 '" + all + " " + kilopascals(sigma3) + "' -o bank.csv (" + cost() + ")"});
  }
}

void check_base(const ObservationSet& set, Reach& reach) {
  if (!set.specimen.box_length || !set.material.nominal_max_size) return;
  const double s = std::cbrt(set.specimen.particles.value_or(300) / 400), own = 3 * s * *set.material.nominal_max_size;
  if (std::abs(*set.specimen.box_length / own - 1) <= kOtherBase) return;
  reach.warnings.push_back("a base of " + shown(*set.specimen.box_length, "m") + ", where the bank's specimen has " + shown(own, "m") +
                           " (3 s L_S): angles of repose and densities depend on it, and are compared all the same");
}

}  // namespace

Reach reach_of(const Emulator& emulator, const ObservationSet& set) {
  Reach reach;
  check_material(set, emulator.space(), reach);
  check_features(emulator, set, reach);
  check_base(set, reach);
  if (reach.refused.empty() && compare(emulator, set).size() == 0) {
    std::string why = "no measured feature is one that the bank has";
    if (!reach.left_out.empty()) why = reach.left_out.front().id + ": " + reach.left_out.front().why;
    std::string key;
    for (const auto& [id, place] : set.places) {
      if (scalar_id(id) || curve_id(id)) key = id;
    }
    reach.refused.push_back({key, "nothing to compare: " + why});
  }
  return reach;
}

}  // namespace regolab::gap
