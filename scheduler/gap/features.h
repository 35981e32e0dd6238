/// From readings to the numbers that a diagnosis compares: one function for files and for our own runs.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "scheduler/gap/readings.h"

namespace regolab::gap {

enum class Test { kSettle, kRepose, kStress, kPenetration };
/// Part of a stress test. Seating: the state after isotropic compression; early, rising: axial strain to 0.015, to 0.04.
enum class Part { kWhole, kSeating, kEarly, kRising, kPeak, kResidual, kStiffness, kVolume, kLateral };
enum class Kind { kPlain, kLog };

/// Where a gap is looked for: a test, under a confining stress, in a part of its curve.
struct Group {
  Test test = Test::kSettle;
  double sigma3 = 0;  ///< [Pa]; 0 outside stress tests, and for a strength line over several
  Part part = Part::kWhole;

  std::string text() const;  ///< "settle", "stress 1.25 kPa residual", "stress strength"
  bool operator==(const Group&) const = default;
  auto operator<=>(const Group&) const = default;
};

/// What a feature is, apart from any value: its one row in the table of all features.
struct FeatureInfo {
  std::string id;     ///< "sigma1_ratio_1.25"; the number is sigma3 in kPa
  std::string label;  ///< "sigma1 at 1.25 kPa"
  Group group;
  Kind kind = Kind::kPlain;
  std::string unit;   ///< SI unit of physical(): "Pa", "rad", "1", ...
  double scale = 1;   ///< physical = scale * exp(value) (log) or scale * value (plain)

  double physical(double value) const;                           ///< [unit]
  double physical_error(double value, double standard_error) const;
  /// "sigma1 at 1.25 kPa is 38 % low", "repose angle is 3.1 deg high": what `value` is beside `reference`.
  std::string difference(double value, double reference) const;
};

struct Feature {
  std::string id;
  Group group;
  double value = 0;
  double standard_error = 0;  ///< of the mean; 0 when the readings carry none
  int repeats = 1;
  bool assumed = false;
};

/// Every feature there can be, in a fixed order: settle, repose, strength, each sigma3 (ascending), each plate ("30x3mm").
std::vector<FeatureInfo> all_features(std::span<const double> sigma3, std::span<const std::string> plates = {});

/// By id, whatever its sigma3 or plate; empty for an id that no feature has.
std::optional<FeatureInfo> feature_info(const std::string& id);

/// Those that the readings allow, in the order of all_features; what is missing or not finite is absent.
std::vector<Feature> features_of(const Readings& readings);

/// Confining stresses [Pa] and plates met in the readings, ascending.
std::vector<double> sigma3_of(const Readings& readings);
std::vector<std::string> plates_of(const Readings& readings);

std::string_view name_of(Test test);
std::string_view name_of(Part part);
std::string_view name_of(Kind kind);

}  // namespace regolab::gap
