/// The one place where SI meets the units people read and the article prints.
#pragma once
#include <numbers>
#include <string>
#include <string_view>

namespace regolab {

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< [rad]

/// A unit as shown at a door: shown = SI value * factor.
struct DoorUnit {
  std::string_view name;
  double factor;
};

/// The article's unit for an SI unit: kg/m3 -> g/cm3, Pa -> kPa, rad -> deg, m -> cm, 1/Pa -> 1/kPa; others stay.
inline DoorUnit door_unit(std::string_view si) {
  if (si == "kg/m3") return {"g/cm3", 1e-3};
  if (si == "Pa") return {"kPa", 1e-3};
  if (si == "rad") return {"deg", 1.0 / kDegree};
  if (si == "m") return {"cm", 100.0};
  if (si == "1/Pa") return {"1/kPa", 1e3};
  return {si, 1.0};
}

/// A column or key suffix for a door unit: "g/cm3" -> "_g_per_cm3", "kPa" -> "_kPa", "1" -> "".
inline std::string unit_suffix(std::string_view door) {
  if (door == "1" || door.empty()) return "";
  std::string text = "_";
  for (const char c : door) {
    if (c == '/') text += "_per_";
    else if (c == ' ' || c == '.') text += '_';
    else text += c;
  }
  return text;
}

}  // namespace regolab
