#include <cmath>
#include <string>

#include "vocab/canonical.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

struct Limit {
  const char* name;
  double value, low, high;
};

std::string outside(const Limit& limit) {
  return std::string(limit.name) + "=" + std::to_string(limit.value) + " (must be from " + std::to_string(limit.low) + " to " +
         std::to_string(limit.high) + ", SI units) change it in the job or design";
}

}  // namespace

std::string breach_of(const StageSpec& spec) {
  const Micro& m = spec.micro;
  const Numerics& n = spec.numerics;
  const Base base = base_of(spec);
  const double largest = m.largest_diameter;
  const Limit limits[] = {
      {"clusters", static_cast<double>(n.clusters), 2, 20000},
      {"friction_angle", m.friction_angle, 0, 1.5533},  // 89 degrees
      {"normal_stiffness", m.normal_stiffness, 1, 1e9},
      {"tangential_stiffness", m.tangential_stiffness, 1, 1e9},
      {"normal_damping", m.normal_damping, 0, 1e4},
      {"tangential_damping", m.tangential_damping, 0, 1e4},
      {"largest_diameter", largest, 1e-5, 1},
      {"grain_density", m.grain_density, 100, 30000},
      {"gravity", m.gravity, 1e-3, 100},
      {"box_length", base.length, 1.05 * largest, 1000 * largest},
      {"box_width", base.width, 1.05 * largest, 1000 * largest},
      {"settle_stiffness_number", n.settle_stiffness_number, 0, 1e9},
      {"stress_stiffness_number", n.stress_stiffness_number, 0, 1e9},
      {"mass_floor", n.mass_floor, 0, 1},
      {"step_fraction", n.step_fraction, 1e-4, 1},
      {"most_damping_ratio", n.most_damping_ratio, 0, 1e3},
      {"isotropic_servo_steps", n.isotropic_servo_steps, 1, 1e6},
      {"inertial_number", n.inertial_number, 1e-6, 1},
      {"axial_strain", n.axial_strain, 0.02, 0.6},
  };
  for (const Limit& limit : limits) {
    if (!(limit.value >= limit.low && limit.value <= limit.high)) return outside(limit);
  }
  if (spec.kind == StageKind::kStress && !(spec.confining_stress >= 1 && spec.confining_stress <= 1e6)) {
    return outside({"confining_stress", spec.confining_stress, 1, 1e6});
  }
  for (const EffectInfo& info : all_effects()) {
    const double strength = spec.effects[info.id];
    if (strength != 0 && !(strength >= info.low && strength <= info.high)) return outside({info.name.data(), strength, info.low, info.high});
  }
  if (spec.kind == StageKind::kStress && !(spec.confining_stress + spec.effects[EffectId::kLateralStressOffset] >= 1)) {
    return outside({"confining_stress + lateral_stress_offset", spec.confining_stress + spec.effects[EffectId::kLateralStressOffset], 1, 1e6});
  }
  if (spec.kind == StageKind::kPenetration) {  // beside the plate a cluster of mean size still finds room
    const double room = 2 * 0.6 * largest;
    const Limit edges[] = {{"plate_width", spec.plate.width, 1e-5, base.length - room},
                           {"plate_thickness", spec.plate.thickness, 1e-5, base.width - room}};
    for (const Limit& edge : edges) {
      if (!(edge.value >= edge.low && edge.value <= edge.high)) return outside(edge);
    }
  }
  return {};
}

}  // namespace regolab
