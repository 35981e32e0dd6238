/// The `factors:` and `fixed:` blocks of a design file.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/field.h"
#include "input/map_reader.h"

namespace regolab {

/// One factor as read: its field, and its levels in file order.
struct FactorLevels {
  Field field;                 ///< read under the study's damping unit
  std::string unit;            ///< of bare numbers, as the file writes it; empty = every value carries its own
  std::vector<double> values;  // [n_levels] SI, or choice numbers
  Place place;                 ///< of its name
};

inline constexpr std::size_t kMostLevels = 64;

/// `theta_F: {unit: degree, levels: [0.1, 20]}` or `theta_F: [0.1 degree, 20 degree]`, per factor, in file order.
std::vector<FactorLevels> read_factors(MapReader& top, DampingUnit damping, Report& report);

/// The index of the level that equals `value` to 9 digits.
std::optional<int> level_of(const FactorLevels& factor, double value);

/// A factor's levels as labels in its door unit.
std::vector<std::string> labels_of(const FactorLevels& factor);

/// A value that does not vary, as given.
struct FixedValue {
  std::string_view name;
  double value = 0;  ///< SI
  Place place;
};

/// Every key of `fixed:` but damping_unit, which must have been read already.
std::vector<FixedValue> read_fixed(MapReader& fixed, DampingUnit damping, Report& report);

}  // namespace regolab
