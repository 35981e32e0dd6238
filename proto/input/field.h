/// Everything a job or a design may set about a material or its numerics: name, unit, range, and where it goes.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "vocab/stage.h"

namespace regolab {

struct Settings {
  Micro micro;
  Numerics numerics;
  EffectSet effects;
};

struct Choice {
  std::string_view name;   ///< as files write it
  std::string_view alias;  ///< the article's writing, also accepted
  int value;
};

struct Field {
  enum class Group { kMicro, kMaterial, kSize, kNumerics, kEffect };  ///< needed / has a default / `particles` / `numerics:` / `effects:`
  Group group = Group::kMicro;
  std::string_view name;
  std::string_view si;                       ///< "1" for pure numbers, counts and choices
  std::string_view what;                     ///< "stiffness"
  double low = 0, high = 0;                  ///< closed range, SI
  bool zero_too = false;                     ///< 0 is allowed beside the range and has a meaning of its own
  bool whole = false;                        ///< a count
  std::string_view usual = {};               ///< what the article uses, for messages
  std::string_view example = {};             ///< a value with unit, for "missing key" messages
  std::span<const Choice> choices = {};      ///< not empty: one of these names
  void (*set)(Settings&, double) = nullptr;  ///< SI value, or the choice's number
};

std::span<const Field> all_fields();

/// Null when there is none of that name.
const Field* find_field(std::string_view name);

/// How the field is shown and labelled: "deg", "N/m", "cm", "g/cm3", "1".
std::string_view door_unit_of(const Field& field);

/// SI value as shown at a door, without unit: "0.1", "mixture".
std::string door_text(const Field& field, double si_value);

/// "between 0.001 and 100 cm".
std::string range_text(const Field& field);

/// The field as it is read under `unit`: eta is N s/m when absolute, a pure number when a ratio.
Field under(const Field& field, DampingUnit unit);

inline constexpr std::string_view kDampingNames[] = {"absolute", "ratio"};

}  // namespace regolab
