/// A made-up world for gap diagnosis as files: a bank of runs and measurements, in closed form. Features answer to friction and N_E; two
/// effects shift them, each in its own way.
#pragma once
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace regolab::test {

struct MadeUpGap {
  static constexpr double kLevels[] = {1.25, 2.5, 5, 10};  // [kPa]

  /// What one specimen shows, in the bank's units. dither: which specimen.
  static std::map<std::string, double> measure(double friction, double elements, double cohesion, double rolling, double dither) {
    const auto noise = [&](double k) { return std::sin(1e4 * friction + 77.7 * dither + 13.1 * k); };
    std::map<std::string, double> f;
    const double stick = std::log1p(cohesion / 600);
    f["contacts_per_particle"] = 4 - 2 * friction + 0.1 * elements - 0.2 * rolling + 0.02 * noise(1);
    f["bulk_density_kg_per_m3"] = 1700 - 200 * friction - 20 * elements - 60 * stick - 100 * rolling + 3 * noise(2);
    f["repose_angle_rad"] = 0.4 + 0.3 * friction + 0.15 * stick + 0.4 * rolling + 0.02 * noise(3);
    for (const double level : kLevels) {
      std::ostringstream at;
      at << "_" << level;
      f["sigma1_ratio" + at.str()] = 0.7 + 0.8 * friction + 0.5 * std::log1p(cohesion / (1000 * level)) + 0.6 * rolling + 0.03 * noise(4 + level);
      f["sigma1_peak_ratio" + at.str()] = 0.8 + 0.9 * friction + 0.02 * elements + 0.5 * std::log1p(cohesion / (1000 * level)) + 0.7 * rolling + 0.03 * noise(5 + level);
    }
    return f;
  }

  static double golden(int k, double step) { return std::fmod(0.5 + step * k, 1.0); }

  /// 60 materials without effects, two seeds each; 24 with each effect.
  static std::string bank_csv() {
    std::ostringstream out;
    out << "experiment,point,seed,profile,theta_F_rad,K_N_N_per_m,eta_N_N_s_per_m,K_T_N_per_m,eta_T_N_s_per_m,L_S_m,N_E,rotation,gravity_m_per_s2,particle_density_kg_per_m3,cohesion_Pa,"
           "rolling_resistance";
    for (const auto& [name, value] : measure(0.5, 4, 0, 0, 1)) out << "," << name;
    out << "\n";
    out.precision(12);
    const auto row = [&](const char* study, int point, int seed, double cohesion, double rolling) {
      const double friction = golden(point, 0.7549), elements = 2.0 * (1 + point % 3);
      out << study << "," << point << "," << seed << ",quick," << friction << ",50000,0.5,50000,0.5,0.02," << elements << ",3,1.63,2930," << cohesion << "," << rolling;
      for (const auto& [name, value] : measure(friction, elements, cohesion, rolling, 100.0 * point + seed)) out << "," << value;
      out << "\n";
    };
    for (int point = 1; point <= 60; ++point) row("null", point, 1, 0, 0), row("null", point, 2, 0, 0);
    for (int k = 1; k <= 24; ++k) row("cohesion", 2 * k, 1, 20 * std::pow(1000.0, golden(k, 0.618)), 0), row("rolling", 2 * k + 1, 1, 0, 0.02 * std::pow(25.0, golden(k, 0.618)));
    return out.str();
  }

  /// Means of three specimens as an observation file.
  static std::string observations_yaml(const std::string& name, double friction, double elements, double cohesion, double rolling) {
    std::map<std::string, double> mean;
    for (int seed = 0; seed < 3; ++seed) {
      for (const auto& [id, value] : measure(friction, elements, cohesion, rolling, 9000 + seed)) mean[id] += value / 3;
    }
    std::ostringstream out;
    out.precision(8);
    out << "format: observations/1\ncase: " << name << "\nmaterial: {nominal_max_size_cm: 2.0, particle_density_g_cm3: 2.93}\nspecimen: {particles: 300, repeats: 3}\n"
        << "nominal_protocol: {gravity_m_s2: 1.63}\nobservables:\n";
    const auto add = [&](const std::string& id, double value, const char* unit, double error) {
      out << "- {id: " << id << ", value: " << value << ", unit: \"" << unit << "\", standard_error: " << error << ", seeds: 3}\n";
    };
    add("contacts_per_particle", mean["contacts_per_particle"], "1", 0.01);
    add("bulk_density", mean["bulk_density_kg_per_m3"] / 1000, "g/cm3", 0.0015);
    add("repose_angle", mean["repose_angle_rad"] * 57.29577951308232, "degree", 0.6);
    for (const double level : kLevels) {
      std::ostringstream at;
      at << "_" << level;
      for (const auto& [feature, id] : std::map<std::string, std::string>{{"sigma1_ratio", "sigma1"}, {"sigma1_peak_ratio", "sigma1_peak"}}) {
        const double stress = level * std::exp(mean[feature + at.str()]);
        add(id + "_at_sigma3" + at.str() + "kPa", stress, "kPa", 0.02 * stress);
      }
    }
    return out.str();
  }
};

}  // namespace regolab::test
