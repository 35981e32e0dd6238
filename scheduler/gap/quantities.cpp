#include "scheduler/gap/quantities.h"

#include <cmath>
#include <span>

#include "input/number_text.h"
#include "input/unit_convert.h"
#include "vocab/plate.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using Tail = Quantity::Tail;
constexpr double kStrong = 1e9;  // [Pa] no soil carries more
constexpr double kOtherWay = -45 * kDegree;  // a line through the top of a bed that stood may fall to either side

// Stand-in errors are those a careful laboratory reaches: balances and rulers 1 %, load cells and repeats 5 %, moduli 15 %, slopes 2 deg,
// a cohesion 20 % and 0.2 kPa.
constexpr Quantity kScalars[] = {
    {.stem = "contacts_per_particle", .si = "1", .what = "contacts", .high = 100, .low_too = true, .assumed_relative = 0.02},
    {.stem = "neighbours_per_particle", .si = "1", .what = "neighbours", .high = 100, .low_too = true, .assumed_relative = 0.02},
    {.stem = "bulk_density", .si = "kg/m3", .what = "density", .high = 20000, .assumed_relative = 0.01},
    {.stem = "bulk_density_Hmax", .si = "kg/m3", .what = "density", .high = 20000, .assumed_relative = 0.02},
    {.stem = "core_density", .si = "kg/m3", .what = "density", .high = 20000, .assumed_relative = 0.02},
    {.stem = "void_ratio", .si = "1", .what = "void ratio", .high = 100, .assumed_relative = 0.02},
    {.stem = "repose_angle", .si = "rad", .what = "angle", .low = kOtherWay, .high = 90 * kDegree, .low_too = true, .assumed_absolute = 2 * kDegree},
    {.stem = "repose_angle_whole", .si = "rad", .what = "angle", .low = kOtherWay, .high = 90 * kDegree, .low_too = true, .assumed_absolute = 2 * kDegree},
    {.stem = "repose_angle_wedge", .si = "rad", .what = "angle", .low = kOtherWay, .high = 90 * kDegree, .low_too = true, .assumed_absolute = 2 * kDegree},
    {.stem = "repose_column_stood", .si = "1", .what = "share of repeats", .high = 1, .low_too = true, .assumed_absolute = 0.3},
    {.stem = "sigma1", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .high = kStrong, .assumed_relative = 0.05},
    {.stem = "sigma1_0.10_0.20", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .high = kStrong, .assumed_relative = 0.05,
     .unused = "overlaps sigma1_at_sigma3 (half of its strains are the same) the curve tells what lies before"},
    {.stem = "sigma1_peak", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .high = kStrong, .assumed_relative = 0.05},
    {.stem = "sigma3_measured", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .high = kStrong, .assumed_relative = 0.02},
    {.stem = "E50", .tail = Tail::kAtSigma3, .si = "Pa", .what = "modulus", .high = 1e12, .assumed_relative = 0.15},
    {.stem = "cohesion", .si = "Pa", .what = "cohesion", .low = -1e6, .high = 1e6, .low_too = true, .assumed_relative = 0.2, .assumed_absolute = 200},
    {.stem = "friction_angle_internal", .si = "rad", .what = "angle", .high = 85 * kDegree, .low_too = true, .assumed_absolute = 2 * kDegree},
    {.stem = "void_ratio_compressed", .tail = Tail::kSigma3, .si = "1", .what = "void ratio", .high = 100, .assumed_relative = 0.02},
};

constexpr Quantity kCurves[] = {
    {.stem = "repose_profile", .si = "m", .what = "height", .low = -100, .high = 100, .low_too = true, .assumed_relative = 0.1},
    {.stem = "sigma1", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .low = -kStrong, .high = kStrong, .low_too = true, .assumed_relative = 0.05},
    {.stem = "sigma3", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .low = -kStrong, .high = kStrong, .low_too = true, .assumed_relative = 0.02},
    {.stem = "volumetric_strain_contraction_positive", .tail = Tail::kAtSigma3, .si = "1", .what = "strain", .low = -10, .high = 1, .low_too = true,
     .assumed_absolute = 0.003},
    {.stem = "top_plate_stress", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .low = -kStrong, .high = kStrong, .low_too = true, .assumed_relative = 0.05},
    {.stem = "bottom_plate_stress", .tail = Tail::kAtSigma3, .si = "Pa", .what = "stress", .low = -kStrong, .high = kStrong, .low_too = true, .assumed_relative = 0.05},
    {.stem = "penetration_force", .tail = Tail::kPlate, .si = "N", .what = "force", .low = -1e9, .high = 1e9, .low_too = true, .assumed_relative = 0.1},
};

/// The stress that "1.25kPa" names [Pa].
std::optional<double> stress_of(std::string_view text) {
  const auto number = leading_number(text);
  if (!number || number->rest.empty() || text.find(' ') != std::string_view::npos) return std::nullopt;
  const auto pascals = convert_to_si(number->value, text, number->rest, "Pa", "sigma3");
  return pascals.ok() && *pascals > 0 ? std::optional(*pascals) : std::nullopt;
}

/// The plate that "30x3mm" names.
std::optional<PlateSize> plate_of(std::string_view text) {
  const auto width = leading_number(text);
  if (!width || !width->rest.starts_with('x')) return std::nullopt;
  const auto thickness = leading_number(width->rest.substr(1));
  const auto sound = [](double mm) { return mm > 0 && mm < 1e5; };
  if (!thickness || thickness->rest != "mm" || !sound(width->value) || !sound(thickness->value)) return std::nullopt;
  return PlateSize{width->value / 1000, thickness->value / 1000};
}

std::string_view joint_of(Tail tail) {
  switch (tail) {
    case Tail::kNone: return "";
    case Tail::kAtSigma3: return "_at_sigma3_";
    case Tail::kSigma3: return "_";
    case Tail::kPlate: return "_plate_";
  }
  return "";
}

std::string completed(const Quantity& quantity, double sigma3) {
  return std::string(quantity.stem) + std::string(joint_of(quantity.tail)) + kilopascals(sigma3) + "kPa";
}

bool takes_stress(const Quantity& quantity) { return quantity.tail == Tail::kAtSigma3 || quantity.tail == Tail::kSigma3; }

std::optional<ObservableId> find(std::span<const Quantity> all, std::string_view id) {
  for (const Quantity& quantity : all) {
    const std::string head = std::string(quantity.stem) + std::string(joint_of(quantity.tail));
    if (quantity.tail == Tail::kNone) {
      if (id == head) return ObservableId{&quantity, 0, head};
      continue;
    }
    if (!id.starts_with(head) || id.size() == head.size()) continue;
    if (quantity.tail == Tail::kPlate) {
      const auto plate = plate_of(id.substr(head.size()));
      if (plate) return ObservableId{&quantity, 0, head + plate_text(*plate)};
      continue;
    }
    if (const auto sigma3 = stress_of(id.substr(head.size()))) return ObservableId{&quantity, *sigma3, completed(quantity, *sigma3)};
  }
  return std::nullopt;
}

std::optional<ObservableId> find(std::span<const Quantity> all, std::string_view stem, double sigma3) {
  for (const Quantity& quantity : all) {
    if (quantity.stem == stem && takes_stress(quantity)) return ObservableId{&quantity, sigma3, completed(quantity, sigma3)};
  }
  return std::nullopt;
}

std::string known(std::span<const Quantity> all) {
  std::string text;
  for (const Quantity& quantity : all) {
    text += (text.empty() ? "" : ", ") + std::string(quantity.stem) + std::string(joint_of(quantity.tail));
    if (takes_stress(quantity)) text += "XkPa";
    if (quantity.tail == Tail::kPlate) text += "WxTmm";
  }
  return text;
}

}  // namespace

std::optional<ObservableId> scalar_id(std::string_view id) { return find(kScalars, id); }
std::optional<ObservableId> curve_id(std::string_view id) { return find(kCurves, id); }
std::optional<ObservableId> curve_id(std::string_view stem, double sigma3) { return find(kCurves, stem, sigma3); }
std::optional<ObservableId> scalar_id(std::string_view stem, double sigma3) { return find(kScalars, stem, sigma3); }

std::string kilopascals(double sigma3) {
  return number_text(std::round(sigma3 * 1e3) / 1e6);  // to the millipascal: 1.25 kPa read from a file is 1.25 kPa
}

std::string known_scalars() { return known(kScalars); }
std::string known_curves() { return known(kCurves); }

std::string_view curve_x_unit(const Quantity& curve) { return curve.tail == Tail::kAtSigma3 ? "1" : "m"; }

}  // namespace regolab::gap
