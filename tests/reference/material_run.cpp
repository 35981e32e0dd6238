#include "reference/material_run.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "vocab/profile.h"
#include "vocab/units.h"
#include "worker/stage/run_stage.h"

namespace regolab::test {
namespace {

Rotation rotation_from(const std::string& name) {
  if (name == "x") return Rotation::kX;
  if (name == "z") return Rotation::kZ;
  return name == "xz" ? Rotation::kXZ : Rotation::kNone;
}

StageOutput output_of(const StageSpec& spec, const std::string& bed) {
  auto output = run_stage(spec, bed, "", {});
  if (!output) {
    std::cerr << output.error().text << "\n";
    return {.result = {.end = StageEnd::kCancelled}};
  }
  if (output->result.end != StageEnd::kCompleted) {
    std::cerr << "seed " << spec.seed << " ended as " << name_of(output->result.end) << ": " << output->result.reason
              << "\n";
  }
  return std::move(*output);
}

void take_measurements(const StageResult& result, Observed& observed) {
  if (result.end != StageEnd::kCompleted) return;
  for (const Measurement& m : result.measurements) observed[m.id] = m.value * door_unit(m.unit).factor;
}

const Curve* curve_named(const StageResult& result, const std::string& id) {
  for (const Curve& curve : result.curves) {
    if (curve.id == id) return &curve;
  }
  return nullptr;
}

/// Mean of sigma1/sigma3 over strains 0.10 to 0.20, as the reference takes it; 0 without curves.
double mean_stress_ratio(const StageResult& result, const std::string& sigma3_text) {
  const Curve* sigma1 = curve_named(result, "sigma1_at_sigma3_" + sigma3_text + "kPa");
  const Curve* sigma3 = curve_named(result, "sigma3_at_sigma3_" + sigma3_text + "kPa");
  if (!sigma1 || !sigma3) return 0;
  double sum = 0;
  int points = 0;
  for (std::size_t i = 0; i < sigma1->x.size(); ++i) {
    if (sigma1->x[i] < 0.10 || sigma1->x[i] > 0.20 || !(sigma3->y[i] > 0)) continue;
    sum += sigma1->y[i] / sigma3->y[i];
    ++points;
  }
  return points > 0 ? sum / points : 0;
}

}  // namespace

StageSpec spec_of(const nlohmann::ordered_json& test, std::uint64_t seed) {
  const auto& micro = test.at("micro");
  StageSpec spec{.kind = StageKind::kSettle, .seed = seed};
  spec.micro = {.friction_angle = micro.at("theta_F").get<double>() * kDegree,
                .normal_stiffness = micro.at("K_N"),
                .normal_damping = micro.at("eta_N"),
                .tangential_stiffness = micro.at("K_T"),
                .tangential_damping = micro.at("eta_T"),
                .largest_diameter = micro.at("L_S").get<double>() / 100,
                .kind = static_cast<ParticleKind>(micro.at("N_E").get<int>()),
                .rotation = rotation_from(micro.at("rotation"))};
  spec.numerics = *profile("quick");
  spec.numerics.clusters = test.at("particles");
  spec.numerics.box_length = test.at("box_length_cm").get<double>() / 100;
  spec.numerics.box_width = test.at("box_width_cm").get<double>() / 100;
  spec.numerics.inertial_number = 5e-3;
  return spec;
}

Observed run_material(const StageSpec& settle) {
  Observed observed;
  const StageOutput settled = output_of(settle, "");
  if (settled.result.end != StageEnd::kCompleted) return observed;
  StageSpec spec = settle;
  for (const StageKind kind : {StageKind::kFabric, StageKind::kRepose}) {
    spec.kind = kind;
    take_measurements(output_of(spec, settled.bed).result, observed);
  }
  spec.kind = StageKind::kStress;
  for (const char* sigma3 : {"1.25", "2.5", "5", "10"}) {
    const double kilopascal = std::stod(sigma3);
    spec.confining_stress = kilopascal * 1000;
    const StageResult result = output_of(spec, settled.bed).result;
    if (result.end != StageEnd::kCompleted) continue;
    observed[std::string("sigma1_at_sigma3_") + sigma3 + "kPa"] = kilopascal * mean_stress_ratio(result, sigma3);
  }
  return observed;
}

}  // namespace regolab::test
