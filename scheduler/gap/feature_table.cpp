#include <cmath>

#include "input/number_text.h"
#include "scheduler/gap/features.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

/// A row for every sigma3: id and label go on with the stress.
struct StressRow {
  std::string_view stem, label;
  Part part;
  Kind kind;
  std::string_view unit;  ///< of physical()
  bool of_sigma3;         ///< the value is a share of sigma3
};

constexpr StressRow kStressRows[] = {
    {"void_ratio_compressed", "void ratio after compression", Part::kSeating, Kind::kPlain, "1", false},
    {"sigma1_early", "sigma1 at 0.5 to 1.5 % strain", Part::kEarly, Kind::kLog, "Pa", true},
    {"sigma1_rising", "sigma1 at 2 to 4 % strain", Part::kRising, Kind::kLog, "Pa", true},
    {"sigma1_middle", "sigma1 at 5 to 10 % strain", Part::kPeak, Kind::kLog, "Pa", true},
    {"sigma1_peak_ratio", "peak sigma1", Part::kPeak, Kind::kLog, "Pa", true},
    {"sigma1_ratio", "sigma1 at 15 to 20 % strain", Part::kResidual, Kind::kLog, "Pa", true},
    {"E50_ratio", "E50", Part::kStiffness, Kind::kLog, "Pa", true},
    {"volumetric_strain_0.05", "contraction at 5 % strain", Part::kVolume, Kind::kPlain, "1", false},
    {"volumetric_strain_0.10", "contraction at 10 % strain", Part::kVolume, Kind::kPlain, "1", false},
    {"volumetric_strain_0.19", "contraction at 19 % strain", Part::kVolume, Kind::kPlain, "1", false},
    {"sigma3_measured_ratio", "measured sigma3", Part::kLateral, Kind::kPlain, "Pa", true},
    {"plate_difference", "top less bottom plate, of their sum,", Part::kLateral, Kind::kPlain, "1", false},
};

struct PlainRow {
  std::string_view id, label;
  Test test;
  Kind kind;
  std::string_view unit;
};

constexpr PlainRow kPlainRows[] = {
    {"contacts_per_particle", "contacts per particle", Test::kSettle, Kind::kPlain, "1"},
    {"neighbours_per_particle", "neighbours per particle", Test::kSettle, Kind::kPlain, "1"},
    {"bulk_density", "bulk density", Test::kSettle, Kind::kPlain, "kg/m3"},
    {"core_density", "core density", Test::kSettle, Kind::kPlain, "kg/m3"},
    {"surface_roughness", "mean over highest density of the bed (roughness)", Test::kSettle, Kind::kLog, "1"},
    {"repose_angle", "repose angle", Test::kRepose, Kind::kPlain, "rad"},
    {"repose_angle_whole", "repose angle of the whole surface", Test::kRepose, Kind::kPlain, "rad"},
    {"repose_wedge", "repose angle of the wedge of equal volume", Test::kRepose, Kind::kPlain, "rad"},
    {"repose_column_stood", "share of slopes that stood", Test::kRepose, Kind::kPlain, "1"},
    {"strength_cohesion", "cohesion", Test::kStress, Kind::kPlain, "Pa"},
    {"strength_friction_angle", "angle of internal friction", Test::kStress, Kind::kPlain, "rad"},
};

constexpr std::string_view kPlateDepths[] = {"0.5", "1.0", "1.5"};  ///< in plate widths

FeatureInfo info_of(const PlainRow& row) {
  return {.id = std::string(row.id), .label = std::string(row.label), .group = {.test = row.test}, .kind = row.kind, .unit = std::string(row.unit), .scale = 1};
}

FeatureInfo info_of(const StressRow& row, double sigma3) {
  const std::string x = kilopascals(sigma3);
  return {.id = std::string(row.stem) + "_" + x, .label = std::string(row.label) + " at " + x + " kPa", .group = {Test::kStress, sigma3, row.part}, .kind = row.kind,
          .unit = std::string(row.unit), .scale = row.of_sigma3 ? sigma3 : 1};
}

FeatureInfo info_of_plate(std::string_view depth, const std::string& plate) {
  return {.id = "penetration_" + std::string(depth) + "w_" + plate, .label = "force at " + std::string(depth) + " plate widths of depth, plate " + plate,
          .group = {.test = Test::kPenetration}, .kind = Kind::kLog, .unit = "N", .scale = 1};
}

std::string short_number(double value) {
  char text[32];
  const int n = std::snprintf(text, sizeof text, value < 99.5 ? "%.2g" : "%.0f", value);
  return {text, static_cast<std::size_t>(n)};
}

}  // namespace

std::string Group::text() const {
  std::string text(name_of(test));
  if (test == Test::kStress) text += sigma3 == 0 ? " strength" : " " + kilopascals(sigma3) + " kPa " + std::string(name_of(part));
  return text;
}

double FeatureInfo::physical(double value) const { return scale * (kind == Kind::kLog ? std::exp(value) : value); }

double FeatureInfo::physical_error(double value, double standard_error) const {
  return kind == Kind::kLog ? std::abs(physical(value)) * standard_error : std::abs(scale) * standard_error;
}

std::string FeatureInfo::difference(double value, double reference) const {
  const double apart = value - reference;
  const std::string side = apart < 0 ? " low" : " high";
  if (kind == Kind::kLog) return label + " is " + short_number(100 * std::abs(std::expm1(apart))) + " %" + side;
  if (unit != "1" && unit != "rad" && reference != 0) return label + " is " + short_number(100 * std::abs(apart / reference)) + " %" + side;
  const DoorUnit door = door_unit(unit);
  return label + " is " + short_number(std::abs(apart) * scale * door.factor) + (unit == "1" ? "" : " " + std::string(door.name)) + side;
}

std::vector<FeatureInfo> all_features(std::span<const double> sigma3, std::span<const std::string> plates) {
  std::vector<FeatureInfo> all;
  for (const PlainRow& row : kPlainRows) all.push_back(info_of(row));
  for (const double stress : sigma3) {
    for (const StressRow& row : kStressRows) all.push_back(info_of(row, stress));
  }
  for (const std::string& plate : plates) {
    for (const std::string_view depth : kPlateDepths) all.push_back(info_of_plate(depth, plate));
  }
  return all;
}

std::optional<FeatureInfo> feature_info(const std::string& id) {
  for (const PlainRow& row : kPlainRows) {
    if (id == row.id) return info_of(row);
  }
  const auto cut = id.rfind('_');
  if (cut == std::string::npos) return std::nullopt;
  const std::string tail = id.substr(cut + 1);
  for (const StressRow& row : kStressRows) {
    if (id.compare(0, cut, row.stem) != 0) continue;
    const auto stress = leading_number(tail);
    if (!stress || !stress->rest.empty() || !(stress->value > 0) || !std::isfinite(stress->value)) return std::nullopt;
    return info_of(row, 1000 * stress->value);
  }
  for (const std::string_view depth : kPlateDepths) {
    if (id.substr(0, cut) == "penetration_" + std::string(depth) + "w") return info_of_plate(depth, tail);
  }
  return std::nullopt;
}

std::string_view name_of(Test test) {
  switch (test) {
    case Test::kSettle: return "settle";
    case Test::kRepose: return "repose";
    case Test::kStress: return "stress";
    case Test::kPenetration: return "penetration";
  }
  return "";
}

std::string_view name_of(Part part) {
  switch (part) {
    case Part::kWhole: return "whole";
    case Part::kSeating: return "seating";
    case Part::kEarly: return "early";
    case Part::kRising: return "rising";
    case Part::kPeak: return "peak";
    case Part::kResidual: return "residual";
    case Part::kStiffness: return "stiffness";
    case Part::kVolume: return "volume";
    case Part::kLateral: return "lateral";
  }
  return "";
}

std::string_view name_of(Kind kind) { return kind == Kind::kLog ? "log" : "plain"; }

}  // namespace regolab::gap
