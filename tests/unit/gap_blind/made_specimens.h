/// Specimens whose numbers are known in closed form, without DEM.
#pragma once
#include <vector>

#include "apparatus/apparatus.h"
#include "scheduler/gap/blind/parts.h"
#include "scheduler/gap/blind/records.h"

namespace regolab::gap {

inline constexpr double kRatio = 4;  ///< sigma1/sigma3, from a strain of 0.02 on

inline StageResult made_fabric(double density) {
  StageResult out;
  out.measurements = {{"contacts_per_particle", 3, "1", {}, "contacts"},
                      {"bulk_density", density, "kg/m3", {}, "mean height"},
                      {"bulk_density_Hmax", 0.9 * density, "kg/m3", {}, "highest"},
                      {"core_density", 1.05 * density, "kg/m3", {}, "core"},
                      {"void_ratio", 2930 / density - 1, "1", {}, "same height"},
                      {"settle_private", 7, "1", {}, "no quantity"}};
  return out;
}

inline StageResult made_repose(double slope) {
  StageResult out;
  out.measurements = {{"repose_column_stood", 0, "1", {}, "share"}, {"repose_angle", std::atan(slope), "rad", {}, "line"}};
  Curve profile{"repose_profile", "repose", "distance_from_left_wall", "m", "surface_height", "m", {}, {}};
  for (int k = 0; k < 24; ++k) {
    profile.x.push_back((k + 0.5) * 0.001);
    profile.y.push_back(slope * (0.024 - profile.x.back()));
  }
  out.curves.push_back(std::move(profile));
  return out;
}

/// Stress rises in a straight line to kRatio sigma3 (times `strength`) at a strain of 0.02, and stays; contraction is a tenth of the strain.
inline StageResult made_stress(double sigma3, double strength = 1) {
  std::vector<StressSample> samples;
  for (int k = 0; k <= 80; ++k) {
    const double strain = 0.00251 * k, sigma1 = sigma3 * (1 + (strength * kRatio - 1) * std::min(1.0, strain / 0.02));
    samples.push_back(
        {.strain = strain, .top = sigma1, .bottom = sigma1, .lateral_x = sigma3, .lateral_y = sigma3, .volumetric_strain = 0.1 * strain});
  }
  StageResult out;
  add_stress_results(samples, sigma3, 0.2, 0.8, out);
  return out;
}

inline SpecimenRecord made_specimen(double density = 1600, double strength = 1) {
  SpecimenRecord out{.fabric = made_fabric(density), .repose = made_repose(0.6), .stress = {}};
  for (const double sigma3 : kBlindStresses) out.stress[sigma3] = made_stress(sigma3, strength);
  return out;
}

}  // namespace regolab::gap
