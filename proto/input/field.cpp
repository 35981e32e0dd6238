#include "input/field.h"

#include <algorithm>
#include <vector>

#include "input/effect_field.h"
#include "input/number_text.h"
#include "vocab/units.h"

namespace regolab {
namespace {

using Group = Field::Group;

// The article writes 12 for the mixture and Non for no rotation [article Table 2].
constexpr Choice kKinds[] = {{"2", "two", 2}, {"4", "four", 4}, {"6", "six", 6}, {"mixture", "12", 12}};
constexpr Choice kRotations[] = {{"none", "Non", 0}, {"x", "X", 1}, {"z", "Z", 2}, {"xz", "XZ", 3}};

void set_kind(Settings& s, double v) { s.micro.kind = static_cast<ParticleKind>(static_cast<int>(v)); }
void set_rotation(Settings& s, double v) { s.micro.rotation = static_cast<Rotation>(static_cast<int>(v)); }
void set_clusters(Settings& s, double v) { s.numerics.clusters = static_cast<int>(v); }

template <double Micro::*member>
void set_micro(Settings& s, double v) {
  s.micro.*member = v;
}
template <double Numerics::*member>
void set_numerics(Settings& s, double v) {
  s.numerics.*member = v;
}

constexpr Field kFields[] = {
    {.name = "theta_F",
     .si = "rad",
     .what = "particle friction angle",
     .low = 0,
     .high = 89 * kDegree,
     .usual = "the article uses 0.1 to 60 deg",
     .example = "20 deg",
     .set = set_micro<&Micro::friction_angle>},
    {.name = "K_N",
     .si = "N/m",
     .what = "stiffness",
     .low = 1,
     .high = 1e9,
     .usual = "the article uses 2.5e4 to 1e5 N/m",
     .example = "1e5 N/m",
     .set = set_micro<&Micro::normal_stiffness>},
    {.name = "eta_N",
     .si = "N s/m",
     .what = "damping constant",
     .low = 0,
     .high = 1e4,
     .usual = "the article uses 0.25 to 1 N s/m",
     .example = "0.25 N s/m",
     .set = set_micro<&Micro::normal_damping>},
    {.name = "K_T",
     .si = "N/m",
     .what = "stiffness",
     .low = 1,
     .high = 1e9,
     .usual = "the article uses 2.5e4 to 1e5 N/m",
     .example = "7.5e4 N/m",
     .set = set_micro<&Micro::tangential_stiffness>},
    {.name = "eta_T",
     .si = "N s/m",
     .what = "damping constant",
     .low = 0,
     .high = 1e4,
     .usual = "the article uses 0.25 to 1 N s/m",
     .example = "1 N s/m",
     .set = set_micro<&Micro::tangential_damping>},
    {.name = "L_S",
     .si = "m",
     .what = "largest particle diameter",
     .low = 1e-5,
     .high = 1,
     .usual = "the article uses 0.5 to 2 cm",
     .example = "1 cm",
     .set = set_micro<&Micro::largest_diameter>},
    {.name = "N_E",
     .si = "1",
     .what = "elements per particle",
     .usual = "12 is the mixture of 2, 4 and 6",
     .example = "6",
     .choices = kKinds,
     .set = set_kind},
    {.name = "rotation",
     .si = "1",
     .what = "random rotation",
     .usual = "the article uses all four",
     .example = "none",
     .choices = kRotations,
     .set = set_rotation},
    {.group = Group::kMaterial,
     .name = "particle_density",
     .si = "kg/m3",
     .what = "density",
     .low = 100,
     .high = 20000,
     .usual = "the article uses 2.93 g/cm3",
     .example = "2.93 g/cm3",
     .set = set_micro<&Micro::grain_density>},
    {.group = Group::kMaterial,
     .name = "gravity",
     .si = "m/s2",
     .what = "acceleration",
     .low = 1e-3,
     .high = 100,
     .usual = "the Moon has 1.63 m/s2; it is a magnitude, without sign",
     .example = "1.63 m/s2",
     .set = set_micro<&Micro::gravity>},
    {.group = Group::kSize,
     .name = "particles",
     .si = "1",
     .what = "number of particles",
     .low = 10,
     .high = 20000,
     .whole = true,
     .usual = "the article uses 1000",
     .set = set_clusters},
    {.group = Group::kNumerics,
     .name = "inertial_number",
     .si = "1",
     .what = "inertial number",
     .low = 1e-5,
     .high = 1,
     .usual = "1e-2 is quick, 1e-3 careful",
     .set = set_numerics<&Numerics::inertial_number>},
    {.group = Group::kNumerics,
     .name = "axial_strain",
     .si = "1",
     .what = "strain",
     .low = 0.02,
     .high = 0.6,
     .usual = "0.20 is usual",
     .set = set_numerics<&Numerics::axial_strain>},
    {.group = Group::kNumerics,
     .name = "step_fraction",
     .si = "1",
     .what = "share of sqrt(m/K)",
     .low = 0.005,
     .high = 0.4,
     .usual = "0.15 is usual",
     .set = set_numerics<&Numerics::step_fraction>},
    {.group = Group::kNumerics,
     .name = "most_damping_ratio",
     .si = "1",
     .what = "share of critical damping",
     .low = 0.2,
     .high = 1e3,
     .zero_too = true,
     .usual = "1 is usual, 0 keeps every dashpot as given",
     .set = set_numerics<&Numerics::most_damping_ratio>},
    {.group = Group::kNumerics,
     .name = "isotropic_servo_steps",
     .si = "1",
     .what = "time steps",
     .low = 10,
     .high = 1e5,
     .usual = "50 is usual, 200 does not shake the specimen",
     .set = set_numerics<&Numerics::isotropic_servo_steps>},
    {.group = Group::kNumerics,
     .name = "settle_stiffness_number",
     .si = "1",
     .what = "K/(p d)",
     .low = 10,
     .high = 1e9,
     .zero_too = true,
     .usual = "300 is quick, 0 keeps the true stiffness",
     .set = set_numerics<&Numerics::settle_stiffness_number>},
    {.group = Group::kNumerics,
     .name = "stress_stiffness_number",
     .si = "1",
     .what = "K/(p d)",
     .low = 10,
     .high = 1e9,
     .zero_too = true,
     .usual = "1000 is quick, 0 keeps the true stiffness",
     .set = set_numerics<&Numerics::stress_stiffness_number>},
    {.group = Group::kNumerics,
     .name = "mass_floor",
     .si = "1",
     .what = "share of L_S",
     .low = 0,
     .high = 1,
     .usual = "0.4 is quick, 0 keeps the true masses",
     .set = set_numerics<&Numerics::mass_floor>},
};

constexpr double kLargestRatio = 10;  // of critical damping; far over-damped already

}  // namespace

std::span<const Field> all_fields() {
  static const std::vector<Field> all = [] {
    std::vector<Field> fields(std::begin(kFields), std::end(kFields));
    const auto effects = effect_fields();
    fields.insert(fields.end(), effects.begin(), effects.end());
    return fields;
  }();
  return all;
}

const Field* find_field(std::string_view name) {
  const auto found = std::ranges::find(all_fields(), name, &Field::name);
  return found == all_fields().end() ? nullptr : &*found;
}

std::string_view door_unit_of(const Field& field) { return door_unit(field.si).name; }

std::string door_text(const Field& field, double si_value) {
  for (const Choice& choice : field.choices) {
    if (choice.value == static_cast<int>(si_value)) return std::string(choice.name);
  }
  return number_text(si_value * door_unit(field.si).factor);
}

std::string range_text(const Field& field) {
  const std::string unit(field.si == "1" ? "" : " " + std::string(door_unit_of(field)));
  return (field.zero_too ? "0 or " : "") + ("between " + door_text(field, field.low)) + " and " +
         door_text(field, field.high) + unit;
}

Field under(const Field& field, DampingUnit unit) {
  Field read = field;
  if (unit == DampingUnit::kRatio && field.si == "N s/m") {
    read.si = "1";
    read.what = "ratio of critical damping";
    read.high = kLargestRatio;
    read.usual = "damping_unit is ratio";
    read.example = "0.25";
  }
  return read;
}

}  // namespace regolab
