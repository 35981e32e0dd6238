#include "worker/output/observations_write.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "vocab/canonical.h"
#include "vocab/units.h"
#include "worker/output/number_text.h"

namespace regolab {
namespace {

using YAML::Key;
using YAML::Value;

void number(YAML::Emitter& out, std::string_view key, double value) {
  out << Key << std::string(key) << Value << yaml_number(value);
}

/// In the door's unit, under a key that ends in it.
void quantity(YAML::Emitter& out, const std::string& key, double si, std::string_view unit, const char* suffix) {
  number(out, key + suffix, shown_value(si, door_unit(unit).factor));
}

void text(YAML::Emitter& out, std::string_view key, std::string_view value) {
  out << Key << std::string(key) << Value;
  if (value == "1" || value.empty()) out << YAML::SingleQuoted;  // a unit of "1" must stay text
  out << std::string(value);
}

void list(YAML::Emitter& out, std::string_view key, const std::vector<double>& values, double factor) {
  out << Key << std::string(key) << Value << YAML::Flow << YAML::BeginSeq;
  for (const double value : values) out << yaml_number(shown_value(value, factor));
  out << YAML::EndSeq;
}

void material(YAML::Emitter& out, const Micro& micro) {
  out << Key << "material" << Value << YAML::BeginMap;
  quantity(out, "nominal_max_size", micro.largest_diameter, "m", "_cm");
  quantity(out, "nominal_min_size", micro.largest_diameter / 5, "m", "_cm");  // [article Sec. 2.2]
  text(out, "nominal_size_law", "uniform in diameter of the circumscribed sphere");
  quantity(out, "particle_density", micro.grain_density, "kg/m3", "_g_cm3");
  out << YAML::EndMap;
}

void specimen(YAML::Emitter& out, const Job& job) {
  const Base base = base_of(stages_of(job).front());
  out << Key << "specimen" << Value << YAML::BeginMap;
  out << Key << "particles" << Value << job.numerics.clusters;
  quantity(out, "box_length", base.length, "m", "_cm");
  quantity(out, "box_width", base.width, "m", "_cm");
  out << Key << "repeats" << Value << 1 << YAML::EndMap;
}

/// rate = I sqrt(p/rho_P)/d with d = 0.6 L_S [protocols, sections 3 and 7] [1/s].
double stated_strain_rate(const Job& job, double sigma3) {
  return job.numerics.inertial_number * std::sqrt(sigma3 / job.micro.grain_density) / (0.6 * job.micro.largest_diameter);
}

void nominal_protocol(YAML::Emitter& out, const Job& job) {
  out << Key << "nominal_protocol" << Value << YAML::BeginMap;
  number(out, "gravity_m_s2", job.micro.gravity);
  text(out, "preparation", "random generation, replacement, sedimentation in a box with plane walls");
  if (job.repose) text(out, "repose", "right wall removed, lowest layer fixed, material falls off the edge");
  if (!job.confining_stresses.empty()) {
    text(out, "stress",
         "no gravity, six plane walls, lateral walls servo-controlled, top plate moves down at a ramped constant rate, "
         "bottom plate fixed");
    list(out, "sigma3_kPa", job.confining_stresses, door_unit("Pa").factor);
    std::vector<double> rates;
    for (const double sigma3 : job.confining_stresses) rates.push_back(stated_strain_rate(job, sigma3));
    list(out, "stated_strain_rate_1_per_s", rates, 1.0);
  }
  if (!job.plates.empty()) {
    text(out, "penetration", "rough plate pushed down at a constant speed, edge first, in the middle of the settled bed to half its depth");
    std::vector<double> widths, thicknesses;
    for (const PlateSize& plate : job.plates) widths.push_back(plate.width), thicknesses.push_back(plate.thickness);
    list(out, "plate_width_cm", widths, door_unit("m").factor);
    list(out, "plate_thickness_cm", thicknesses, door_unit("m").factor);
  }
  out << YAML::EndMap;
}

void observable(YAML::Emitter& out, const Measurement& m) {
  const DoorUnit door = door_unit(m.unit);
  out << YAML::BeginMap;
  text(out, "id", m.id);
  number(out, "value", shown_value(m.value, door.factor));
  text(out, "unit", door.name);
  out << Key << "standard_error" << Value;
  if (m.standard_error && std::isfinite(*m.standard_error))
    out << yaml_number(shown_value(*m.standard_error, door.factor));
  else
    out << YAML::Null;
  out << Key << "seeds" << Value << 1;
  text(out, "definition", m.definition);
  out << YAML::EndMap;
}

void curve(YAML::Emitter& out, const Curve& c, const StageSpec& spec) {
  const DoorUnit x_door = door_unit(c.x_unit);
  const DoorUnit y_door = door_unit(c.y_unit);
  out << YAML::BeginMap;
  text(out, "id", c.id);
  text(out, "test", c.test);
  if (spec.kind == StageKind::kStress) quantity(out, "sigma3", spec.confining_stress, "Pa", "_kPa");
  text(out, "x_name", c.x_name);
  text(out, "x_unit", x_door.name);
  list(out, "x", c.x, x_door.factor);
  text(out, "y_name", c.y_name);
  text(out, "y_unit", y_door.name);
  list(out, "y", c.y, y_door.factor);
  out << Key << "y_standard_error" << Value << YAML::Null << Key << "seeds" << Value << 1 << YAML::EndMap;
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

std::string observations_yaml(const Job& job, const std::vector<FinishedStage>& stages, const std::string& case_name) {
  YAML::Emitter out;
  out.SetNullFormat(YAML::LowerNull);
  out << YAML::BeginMap;
  text(out, "format", "observations/1");
  text(out, "source", "same_code");
  text(out, "case", case_name);
  material(out, job.micro);
  specimen(out, job);
  nominal_protocol(out, job);
  out << Key << "observables" << Value << YAML::BeginSeq;
  for (const FinishedStage& stage : stages) {
    if (stage.result.end != StageEnd::kCompleted) continue;
    for (const Measurement& m : stage.result.measurements) {
      if (std::isfinite(m.value)) observable(out, m);
    }
  }
  out << YAML::EndSeq << Key << "curves" << Value << YAML::BeginSeq;
  for (const FinishedStage& stage : stages) {
    if (stage.result.end != StageEnd::kCompleted) continue;
    for (const Curve& c : stage.result.curves) {
      if (finite(c.x) && finite(c.y)) curve(out, c, stage.spec);
    }
  }
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace regolab
