#include "rpc/convert.h"

#include <cmath>

namespace regolab {
namespace {

v1::Measurement to_proto(const Measurement& m) {
  v1::Measurement out;
  out.set_id(m.id);
  out.set_value_si(m.value);
  out.set_unit_si(m.unit);
  if (m.standard_error) out.set_standard_error_si(*m.standard_error);
  out.set_definition(m.definition);
  return out;
}

Measurement from_proto(const v1::Measurement& m) {
  Measurement out{m.id(), m.value_si(), m.unit_si(), {}, m.definition()};
  if (m.has_standard_error_si()) out.standard_error = m.standard_error_si();
  return out;
}

v1::Curve to_proto(const Curve& c) {
  v1::Curve out;
  out.set_id(c.id);
  out.set_test(c.test);
  out.set_x_name(c.x_name);
  out.set_x_unit_si(c.x_unit);
  out.set_y_name(c.y_name);
  out.set_y_unit_si(c.y_unit);
  out.mutable_x_si()->Add(c.x.begin(), c.x.end());
  out.mutable_y_si()->Add(c.y.begin(), c.y.end());
  return out;
}

Curve from_proto(const v1::Curve& c) {
  return {c.id(),
          c.test(),
          c.x_name(),
          c.x_unit_si(),
          c.y_name(),
          c.y_unit_si(),
          {c.x_si().begin(), c.x_si().end()},
          {c.y_si().begin(), c.y_si().end()}};
}

bool finite(std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

Result<EffectSet> effects_from(const v1::StageSpec& spec) {
  EffectSet effects;
  for (const auto& [name, strength] : spec.effects()) {
    const EffectInfo* info = find_effect(name);
    if (info == nullptr) return invalid("stage refused (unknown effect '" + name + "'), update the older of worker and scheduler");
    if (!std::isfinite(strength)) return invalid("stage refused (effect " + name + " is not a finite number)");
    effects[info->id] = strength;
  }
  return effects;
}

}  // namespace

v1::StageSpec to_proto(const StageSpec& spec) {
  v1::StageSpec out;
  out.set_kind(static_cast<v1::StageKind>(spec.kind));
  out.set_seed(spec.seed);
  out.set_confining_stress_pa(spec.confining_stress);
  out.set_plate_width_m(spec.plate.width);
  out.set_plate_thickness_m(spec.plate.thickness);
  for (const EffectInfo& info : all_effects()) {
    if (spec.effects[info.id] != 0) (*out.mutable_effects())[std::string(info.name)] = spec.effects[info.id];
  }
  v1::Micro& m = *out.mutable_micro();
  m.set_friction_angle_rad(spec.micro.friction_angle);
  m.set_normal_stiffness_n_per_m(spec.micro.normal_stiffness);
  m.set_normal_damping(spec.micro.normal_damping);
  m.set_tangential_stiffness_n_per_m(spec.micro.tangential_stiffness);
  m.set_tangential_damping(spec.micro.tangential_damping);
  m.set_largest_diameter_m(spec.micro.largest_diameter);
  m.set_kind(static_cast<v1::ParticleKind>(spec.micro.kind));
  m.set_rotation(static_cast<v1::Rotation>(spec.micro.rotation));
  m.set_damping_unit(static_cast<v1::DampingUnit>(spec.micro.damping_unit));
  m.set_grain_density_kg_per_m3(spec.micro.grain_density);
  m.set_gravity_m_per_s2(spec.micro.gravity);
  v1::Numerics& n = *out.mutable_numerics();
  n.set_clusters(spec.numerics.clusters);
  n.set_box_length_m(spec.numerics.box_length);
  n.set_box_width_m(spec.numerics.box_width);
  n.set_settle_stiffness_number(spec.numerics.settle_stiffness_number);
  n.set_stress_stiffness_number(spec.numerics.stress_stiffness_number);
  n.set_mass_floor(spec.numerics.mass_floor);
  n.set_step_fraction(spec.numerics.step_fraction);
  n.set_inertial_number(spec.numerics.inertial_number);
  n.set_axial_strain(spec.numerics.axial_strain);
  n.set_most_damping_ratio(spec.numerics.most_damping_ratio);
  n.set_isotropic_servo_steps(spec.numerics.isotropic_servo_steps);
  return out;
}

Result<StageSpec> from_proto(const v1::StageSpec& spec) {
  const v1::Micro& m = spec.micro();
  const v1::Numerics& n = spec.numerics();
  if (!v1::StageKind_IsValid(spec.kind()) || !v1::Rotation_IsValid(m.rotation()) ||
      !v1::DampingUnit_IsValid(m.damping_unit()) || !v1::ParticleKind_IsValid(m.kind()) ||
      m.kind() == v1::PARTICLE_KIND_UNSPECIFIED) {
    return invalid("stage refused (an unknown kind, rotation or damping unit), update the older of worker and scheduler");
  }
  const auto effects = effects_from(spec);
  if (!effects.ok()) return effects.error();
  StageSpec out{.kind = static_cast<StageKind>(spec.kind()),
                .micro = {.friction_angle = m.friction_angle_rad(),
                          .normal_stiffness = m.normal_stiffness_n_per_m(),
                          .normal_damping = m.normal_damping(),
                          .tangential_stiffness = m.tangential_stiffness_n_per_m(),
                          .tangential_damping = m.tangential_damping(),
                          .largest_diameter = m.largest_diameter_m(),
                          .kind = static_cast<ParticleKind>(m.kind()),
                          .rotation = static_cast<Rotation>(m.rotation()),
                          .damping_unit = static_cast<DampingUnit>(m.damping_unit()),
                          .grain_density = m.grain_density_kg_per_m3(),
                          .gravity = m.gravity_m_per_s2()},
                .numerics = {.clusters = n.clusters(),
                             .box_length = n.box_length_m(),
                             .box_width = n.box_width_m(),
                             .settle_stiffness_number = n.settle_stiffness_number(),
                             .stress_stiffness_number = n.stress_stiffness_number(),
                             .mass_floor = n.mass_floor(),
                             .step_fraction = n.step_fraction(),
                             .most_damping_ratio = n.most_damping_ratio(),
                             .isotropic_servo_steps = n.isotropic_servo_steps() == 0 ? Numerics{}.isotropic_servo_steps : n.isotropic_servo_steps(),
                             .inertial_number = n.inertial_number(),
                             .axial_strain = n.axial_strain()},
                .seed = spec.seed(),
                .confining_stress = spec.confining_stress_pa(),
                .plate = {.width = spec.plate_width_m(), .thickness = spec.plate_thickness_m()},
                .effects = *effects};
  const Micro& c = out.micro;
  const Numerics& d = out.numerics;
  if (!finite({c.friction_angle, c.normal_stiffness, c.normal_damping, c.tangential_stiffness, c.tangential_damping,
               c.largest_diameter, c.grain_density, c.gravity, d.box_length, d.box_width, d.settle_stiffness_number,
               d.stress_stiffness_number, d.mass_floor, d.step_fraction, d.most_damping_ratio, d.isotropic_servo_steps, d.inertial_number, d.axial_strain,
               out.confining_stress, out.plate.width, out.plate.thickness})) {
    return invalid("stage refused (a parameter is not a finite number)");
  }
  return out;
}

v1::StageResult to_proto(const StageResult& result) {
  v1::StageResult out;
  out.set_end(static_cast<v1::StageEnd>(result.end));
  out.set_reason(result.reason);
  for (const Measurement& m : result.measurements) *out.add_measurements() = to_proto(m);
  for (const Measurement& m : result.numerics) *out.add_numerics() = to_proto(m);
  for (const Curve& c : result.curves) *out.add_curves() = to_proto(c);
  return out;
}

Result<StageResult> from_proto(const v1::StageResult& result) {
  if (!v1::StageEnd_IsValid(result.end())) {
    return invalid("result refused (unknown end " + std::to_string(result.end()) + "), update the scheduler");
  }
  StageResult out;
  out.end = static_cast<StageEnd>(result.end());
  out.reason = result.reason();
  for (const auto& m : result.measurements()) out.measurements.push_back(from_proto(m));
  for (const auto& m : result.numerics()) out.numerics.push_back(from_proto(m));
  for (const auto& c : result.curves()) out.curves.push_back(from_proto(c));
  return out;
}

}  // namespace regolab
