#include "vocab/canonical.h"

#include <cmath>
#include <map>

#include "vocab/exact_text.h"

namespace regolab {
namespace {

std::string shortest(double value) { return exact_text(value); }

using Fields = std::map<std::string, std::string>;  // sorted by name

std::string join(const Fields& fields) {
  std::string text;
  for (const auto& [name, value] : fields) text += name + "=" + value + "\n";
  return text;
}

Fields bed_fields(const StageSpec& spec) {
  const Micro& m = spec.micro;
  const Numerics& n = spec.numerics;
  const Base base = base_of(spec);
  return {
      {"box_length", shortest(base.length)},
      {"box_width", shortest(base.width)},
      {"clusters", std::to_string(n.clusters)},
      {"damping_unit", std::to_string(static_cast<int>(m.damping_unit))},
      {"friction_angle", shortest(m.friction_angle)},
      {"grain_density", shortest(m.grain_density)},
      {"gravity", shortest(m.gravity)},
      {"kind", std::to_string(static_cast<int>(m.kind))},
      {"largest_diameter", shortest(m.largest_diameter)},
      {"mass_floor", shortest(n.mass_floor)},
      {"most_damping_ratio", shortest(n.most_damping_ratio)},
      {"normal_damping", shortest(m.normal_damping)},
      {"normal_stiffness", shortest(m.normal_stiffness)},
      {"rotation", std::to_string(static_cast<int>(m.rotation))},
      {"seed", std::to_string(spec.seed)},
      {"settle_stiffness_number", shortest(n.settle_stiffness_number)},
      {"step_fraction", shortest(n.step_fraction)},
      {"tangential_damping", shortest(m.tangential_damping)},
      {"tangential_stiffness", shortest(m.tangential_stiffness)},
  };
}

Fields stress_fields(const StageSpec& spec) {
  const Numerics& n = spec.numerics;
  Fields fields = {{"axial_strain", shortest(n.axial_strain)},
                   {"confining_stress", shortest(spec.confining_stress)},
                   {"inertial_number", shortest(n.inertial_number)},
                   {"stress_stiffness_number", shortest(n.stress_stiffness_number)}};
  // Named only where it differs, so that results from before it could be chosen keep their keys.
  if (n.isotropic_servo_steps != Numerics{}.isotropic_servo_steps) fields["isotropic_servo_steps"] = shortest(n.isotropic_servo_steps);
  return fields;
}

/// One line per effect that is on: its name, version and strength. The bed's effects stand with the bed, a test's own with the test.
std::string effect_lines(const EffectSet& effects) {
  Fields lines;
  for (const EffectInfo& info : all_effects()) {
    if (effects[info.id] == 0) continue;
    lines["effect " + std::string(info.name)] = shortest(effects[info.id]) + " version " + std::to_string(info.version);
  }
  return join(lines);
}

/// Effects of a stage that its bed does not have.
EffectSet beyond_the_bed(const StageSpec& spec) {
  EffectSet own = acting_in(spec.effects, spec.kind);
  for (const EffectInfo& info : all_effects()) {
    if ((info.acts_in & acts::kSettle) != 0) own[info.id] = 0;
  }
  return own;
}

}  // namespace

Base base_of(const StageSpec& spec) {
  const double s = std::cbrt(spec.numerics.clusters / 400.0);
  const double largest = spec.micro.largest_diameter;
  return {spec.numerics.box_length > 0 ? spec.numerics.box_length : 3.0 * s * largest,
          spec.numerics.box_width > 0 ? spec.numerics.box_width : 2.4 * s * largest};
}

std::string canonical_text(const StageSpec& spec) {
  std::string text = "regolab stage, physics " + std::to_string(kPhysicsVersion) + "\n[settle]\n" + join(bed_fields(spec)) +
                     effect_lines(acting_in(spec.effects, StageKind::kSettle));
  switch (spec.kind) {
    case StageKind::kSettle: break;
    case StageKind::kFabric: text += "[fabric]\n"; break;
    case StageKind::kRepose: text += "[repose]\n"; break;
    case StageKind::kStress:
      text += "[stress]\n" + join(stress_fields(spec));
      break;
    case StageKind::kPenetration:
      text += "[penetration]\n" + join({{"inertial_number", shortest(spec.numerics.inertial_number)},
                                        {"plate_thickness", shortest(spec.plate.thickness)},
                                        {"plate_width", shortest(spec.plate.width)}});
      break;
  }
  return spec.kind == StageKind::kSettle ? text : text + effect_lines(beyond_the_bed(spec));
}

}  // namespace regolab
