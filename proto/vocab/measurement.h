/// What a stage leaves behind: numbers, curves, and how it ended. SI inside; doors convert with units.h.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace regolab {

/// A simulation that blows up, never settles or is cancelled is data, not an error.
enum class StageEnd {
  kCompleted = 0,
  kNotSettled = 1,    ///< the time limit came before rest
  kEnergyGrowth = 2,  ///< mechanical energy rose beyond the work put in
  kOverlap = 3,       ///< an overlap passed its limit
  kUnstable = 4,      ///< a number stopped being finite
  kLostCluster = 5,   ///< a cluster left the box
  kNoRoom = 6,        ///< the parent spheres did not fit the filling box
  kCancelled = 7,
};

/// One number with its id from the observation format (`bulk_density`, `sigma1_at_sigma3_2.5kPa`, ...).
struct Measurement {
  std::string id;
  double value = 0;   ///< SI
  std::string unit;   ///< the SI unit: "1", "kg/m3", "rad", "Pa", "m", "s", "1/s", "J", "N"
  std::optional<double> standard_error;  ///< SI, where the protocol itself yields one (strips, time average)
  std::string definition;                ///< one line, for observation files

  bool operator==(const Measurement&) const = default;
};

struct Curve {
  std::string id;      ///< `repose_profile`, `sigma1_at_sigma3_2.5kPa`, ...
  std::string test;    ///< `settle`, `repose`, `stress`, `penetration`
  std::string x_name, x_unit, y_name, y_unit;  ///< units SI as above
  std::vector<double> x, y;                    // [n_points]

  bool operator==(const Curve&) const = default;
};

struct StageResult {
  StageEnd end = StageEnd::kCompleted;
  std::string reason;                      ///< empty when completed; else problem (why) remedy
  std::vector<Measurement> measurements;   ///< responses
  std::vector<Measurement> numerics;       ///< time step, steps, stiffness used, servo error, energy error, ...
  std::vector<Curve> curves;

  bool operator==(const StageResult&) const = default;
};

std::string_view name_of(StageEnd end);

}  // namespace regolab
