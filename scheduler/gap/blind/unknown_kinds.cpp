#include "scheduler/gap/blind/unknown_kinds.h"

#include <algorithm>

namespace regolab::gap {
namespace {

double either(Chance& chance, double low, double high) {
  const double size = chance.between(low, high);
  return rounded(chance.coin() ? size : -size);
}

void draw_batches(Chance& chance, Truth& t) {
  const double apart = chance.between(20, 35);
  const bool up = t.material.friction_deg + apart < 60 && (t.material.friction_deg < apart || chance.coin());
  t.parameters["theta_F_deg"] = rounded(up ? t.material.friction_deg + apart : std::max(0.1, t.material.friction_deg - apart));
  t.parameters["N_E"] = t.material.elements == "2" ? 6 : 2;
}

void draw_friction(Chance& chance, Truth& t) {
  double at_low = rounded(chance.between(25, 45)), at_high = rounded(chance.between(3, 9));
  if (chance.coin()) std::swap(at_low, at_high);
  t.material.friction_deg = at_low;
  t.parameters["theta_F_deg_at_10_kPa"] = at_high;
}

void draw_softening(Chance& chance, Truth& t) {
  t.material.normal_stiffness = rounded(chance.between(6e4, 1e5));  // or the grains of the last test would be pressed flat
  t.material.tangential_stiffness = rounded(chance.between(6e4, 1e5));
  t.parameters["stiffness_ratio_at_10_kPa"] = rounded(chance.by_ratio(1.0 / 30, 1.0 / 10));
}

constexpr UnknownKind kKinds[] = {
    {"batches", "density and repose were measured on one batch, the stress tests on another", "none: two materials at once",
     "theta_F of the other batch 20 to 35 deg apart, N_E 2 or 6", true, &draw_batches},
    {"friction_by_stress", "grain friction changes with the stress it is sheared under",
     "cohesion, where it falls: but without cohesive slopes, and in the volume change",
     "theta_F at 1.25 and at 10 kPa: one 25 to 45, the other 3 to 9 deg, in equal steps between", true, &draw_friction},
    {"softening", "grains become softer from test to test, from the lowest sigma3 to the highest", "hertzian_contact, which does the opposite",
     "K_N and K_T at 10 kPa 1/30 to 1/10 of those at 1.25 kPa, in equal ratios", true, &draw_softening},
    {"misscaled_range", "the pressure regulator's upper range is off: 5 and 10 kPa are not what they are said to be",
     "load_cell_gain, which is the same at every sigma3", "factor 0.6 to 0.75 or 1.35 to 1.6", true,
     [](Chance& c, Truth& t) { t.parameters["factor"] = rounded(c.coin() ? c.between(0.6, 0.75) : c.between(1.35, 1.6)); }},
    {"drifting_load_cell", "the axial load cell drifts in proportion to the strain of each test",
     "lateral_stress_offset, which stays once it is there", "6 to 15 kPa at 20 % strain", false,
     [](Chance& c, Truth& t) { t.parameters["drift_at_0.2_Pa"] = rounded(c.by_ratio(6000, 15000)); }},
    {"saturating_load_cell", "the axial load cell saturates: s/sqrt(1 + (s/s_0)^2)",
     "breakage, by its lower peaks at high sigma3: but nothing happens to the volume", "s_0 of 8 to 14 kPa", false,
     [](Chance& c, Truth& t) { t.parameters["s_0_Pa"] = rounded(c.by_ratio(8e3, 14e3)); }},
    {"swapped_records", "the axial records of two neighbouring tests were interchanged", "none: right numbers at the wrong sigma3",
     "first of the two, 0 to 2", false, [](Chance& c, Truth& t) { t.parameters["first"] = static_cast<double>(c.below(3)); }},
    {"leaking_volume_gauge", "the volume gauge leaks in proportion to the strain, which reads as dilation",
     "boundary_compliance, which reads as contraction", "0.12 to 0.25 at 20 % strain", false,
     [](Chance& c, Truth& t) { t.parameters["leak_at_0.2"] = rounded(c.between(0.12, 0.25)); }},
    {"misread_height", "the height of the settled bed is misread", "grain_density, which moves the density of the core too", "12 to 25 %, up or down",
     false, [](Chance& c, Truth& t) { t.parameters["share"] = either(c, 0.12, 0.25); }},
    {"bottom_cell_gain", "the bottom plate's load cell reads too much, the top plate's is right", "wall_friction, which unloads the bottom plate",
     "35 to 80 %", false, [](Chance& c, Truth& t) { t.parameters["gain"] = rounded(c.between(0.35, 0.8)); }},
};

}  // namespace

std::span<const UnknownKind> unknown_kinds() { return kKinds; }

const UnknownKind* find_unknown(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, &UnknownKind::name);
  return found == std::end(kKinds) ? nullptr : found;
}

}  // namespace regolab::gap
