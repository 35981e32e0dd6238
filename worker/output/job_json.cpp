#include "worker/output/job_json.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "vocab/canonical.h"
#include "vocab/units.h"
#include "worker/output/finished_stage.h"
#include "worker/output/number_text.h"

namespace regolab {
namespace {

using Json = nlohmann::ordered_json;

Json quantity(double si, std::string_view unit) {
  const DoorUnit door = door_unit(unit);
  return {{"value", si}, {"unit", unit}, {"shown", shown_value(si, door.factor)}, {"shown_unit", door.name}};
}

std::string_view rotation_name(Rotation rotation) {
  switch (rotation) {
    case Rotation::kNone: return "none";
    case Rotation::kX: return "x";
    case Rotation::kZ: return "z";
    case Rotation::kXZ: return "xz";
  }
  return "unknown";
}

Json micro_json(const Micro& m) {
  const bool ratio = m.damping_unit == DampingUnit::kRatio;
  const std::string_view damping_unit = ratio ? "1" : "N s/m";
  return {{"theta_F", quantity(m.friction_angle, "rad")},
          {"K_N", quantity(m.normal_stiffness, "N/m")},
          {"eta_N", quantity(m.normal_damping, damping_unit)},
          {"K_T", quantity(m.tangential_stiffness, "N/m")},
          {"eta_T", quantity(m.tangential_damping, damping_unit)},
          {"L_S", quantity(m.largest_diameter, "m")},
          {"N_E", static_cast<int>(m.kind)},
          {"rotation", rotation_name(m.rotation)},
          {"damping_unit", ratio ? "ratio" : "absolute"},
          {"grain_density", quantity(m.grain_density, "kg/m3")},
          {"gravity", quantity(m.gravity, "m/s2")}};
}

Json numerics_json(const Job& job) {
  const Numerics& n = job.numerics;
  const Base base = base_of(stages_of(job).front());
  return {{"clusters", n.clusters},
          {"box_length", quantity(base.length, "m")},
          {"box_width", quantity(base.width, "m")},
          {"settle_stiffness_number", n.settle_stiffness_number},
          {"stress_stiffness_number", n.stress_stiffness_number},
          {"mass_floor", n.mass_floor},
          {"step_fraction", n.step_fraction},
          {"most_damping_ratio", n.most_damping_ratio},
          {"isotropic_servo_steps", n.isotropic_servo_steps},
          {"inertial_number", n.inertial_number},
          {"axial_strain", n.axial_strain}};
}

}  // namespace

Json job_json(const Job& job) {
  Json tests = Json::array({"settle"});
  if (job.repose) tests.push_back("repose");
  if (!job.confining_stresses.empty()) tests.push_back("stress");
  if (!job.plates.empty()) tests.push_back("penetration");
  Json sigma3 = Json::array();
  for (const double stress : job.confining_stresses) sigma3.push_back(quantity(stress, "Pa"));
  Json json{{"profile", job.profile},         {"seed", job.seed},          {"micro", micro_json(job.micro)},
            {"numerics", numerics_json(job)}, {"tests", std::move(tests)}, {"sigma3", std::move(sigma3)}};
  for (const EffectInfo& info : all_effects()) {
    if (job.effects[info.id] == 0) continue;
    const bool choice = !info.choices.empty();
    const double strength = job.effects[info.id];
    json["effects"][std::string(info.name)] =
        choice ? Json(info.choices[static_cast<std::size_t>(strength)]) : quantity(strength, info.si);
  }
  for (const PlateSize& plate : job.plates) {
    json["plates"].push_back({{"width", quantity(plate.width, "m")}, {"thickness", quantity(plate.thickness, "m")}});
  }
  return json;
}

}  // namespace regolab
