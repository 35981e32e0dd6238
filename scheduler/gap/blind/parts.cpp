#include "scheduler/gap/blind/parts.h"

#include <cmath>

#include "input/number_text.h"
#include "vocab/effects.h"

namespace regolab::gap {
namespace {

std::vector<StressLevel> all_stresses() {
  std::vector<StressLevel> out;
  for (const double sigma3 : kBlindStresses) out.push_back({sigma3, sigma3});
  return out;
}

/// The bed from the first material, and a material of its own for each stress test.
template <class At>
std::vector<BlindPart> material_by_stress(const Truth& truth, const At& at) {
  std::vector<BlindPart> out;
  for (std::size_t k = 0; k < std::size(kBlindStresses); ++k) {
    BlindMaterial material = truth.material;
    at(material, static_cast<double>(k) / (std::size(kBlindStresses) - 1.0));
    out.push_back({material, k == 0, {{kBlindStresses[k], kBlindStresses[k]}}});
  }
  return out;
}

std::string strengths(const Truth& truth) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) { text += (text.empty() ? "" : ", ") + name + ": " + value; };
  for (const auto& [name, strength] : truth.effects) {
    const EffectInfo* effect = find_effect(name);
    add(name, number_text(strength) + (effect->si == "1" ? "" : " " + std::string(effect->si)));
  }
  for (const auto& [name, law] : truth.variants) add(name, law);
  return text.empty() ? "" : "effects: {" + text + "}\n";
}

}  // namespace

std::vector<BlindPart> parts_of(const Truth& truth) {
  const auto parameter = [&](const char* name) { return truth.parameters.at(name); };
  if (truth.unknown == "batches") {
    BlindMaterial other = truth.material;
    other.friction_deg = parameter("theta_F_deg");
    other.elements = number_text(parameter("N_E"));
    return {{truth.material, true, {}}, {other, false, all_stresses()}};
  }
  if (truth.unknown == "friction_by_stress") {
    const double last = parameter("theta_F_deg_at_10_kPa");
    return material_by_stress(truth, [&](BlindMaterial& m, double share) { m.friction_deg += share * (last - m.friction_deg); });
  }
  if (truth.unknown == "softening") {
    const double ratio = parameter("stiffness_ratio_at_10_kPa");
    return material_by_stress(truth, [&](BlindMaterial& m, double share) {
      m.normal_stiffness *= std::pow(ratio, share);
      m.tangential_stiffness *= std::pow(ratio, share);
    });
  }
  auto stress = all_stresses();
  if (truth.unknown == "misscaled_range") {
    for (std::size_t k = 2; k < stress.size(); ++k) stress[k].applied = std::round(stress[k].said * parameter("factor"));
  }
  return {{truth.material, true, stress}};
}

BlindDesign design_of(const Truth& truth, std::size_t part) {
  const BlindPart p = parts_of(truth)[part];
  const BlindMaterial& m = p.material;
  std::string seeds, stresses;
  for (const std::uint64_t seed : truth.seeds) seeds += (seeds.empty() ? "" : ", ") + std::to_string(seed);
  for (const StressLevel& level : p.stress) stresses += (stresses.empty() ? "" : ", ") + number_text(level.applied / 1000) + " kPa";
  BlindDesign out;
  out.yaml = "name: blind-" + truth.id + "\nprofile: quick\nparticles: " + std::to_string(truth.particles) + "\nseeds: [" + seeds +
             "]\narray: {table: case.csv}\nfixed: {particle_density: 2.93 g/cm3, K_N: " + number_text(m.normal_stiffness) +
             " N/m, eta_N: " + number_text(m.normal_damping) + " N s/m, K_T: " + number_text(m.tangential_stiffness) +
             " N/m, eta_T: " + number_text(m.tangential_damping) + " N s/m, L_S: " + number_text(m.largest_cm) + " cm, N_E: " + m.elements +
             ", rotation: " + m.rotation + ", gravity: " + number_text(m.gravity) + " m/s2}\n" + strengths(truth) +
             "numerics: {stress_stiffness_number: 0, isotropic_servo_steps: 200, step_fraction: " + number_text(truth.step_fraction) + "}\n";
  out.yaml += std::string("tests: [settle, contacts, density") + (p.bed ? ", repose" : "") +
              (p.stress.empty() ? "]\n" : ", stress]\nstress: {sigma3: [" + stresses + "]}\n");
  out.table = "theta_F_deg\n" + number_text(m.friction_deg) + "\n";  // a design varies something, if only by name
  return out;
}

}  // namespace regolab::gap
