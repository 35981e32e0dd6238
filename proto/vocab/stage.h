/// One stage of the study, as a pure function of what stands here. The scheduler makes stages, the worker runs them.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "vocab/effects.h"
#include "vocab/micro.h"
#include "vocab/plate.h"

namespace regolab {

/// Bumped whenever the same StageSpec would give other bits: results of another version are never mixed.
inline constexpr int kPhysicsVersion = 3;

enum class StageKind {
  kSettle = 0,  ///< generation, replacement, sedimentation; leaves a bed
  kFabric = 1,  ///< contacts, contact angles, density, void ratio of the settled bed; no DEM steps
  kRepose = 2,  ///< angle of repose
  kStress = 3,  ///< stress test at one confining pressure
  kPenetration = 4,  ///< one plate pushed into the settled bed
};

inline std::string_view name_of(StageKind kind) {
  switch (kind) {
    case StageKind::kSettle: return "settle";
    case StageKind::kFabric: return "fabric";
    case StageKind::kRepose: return "repose";
    case StageKind::kStress: return "stress";
    case StageKind::kPenetration: return "penetration";
  }
  return "unknown";
}

/// What a profile decides, written out. Zero stiffness number = the true stiffness; zero mass floor = true masses.
struct Numerics {
  int clusters = 300;
  double box_length = 0;               ///< [m]; 0 = 3 s L_S, s = (clusters/400)^(1/3)
  double box_width = 0;                ///< [m]; 0 = 2.4 s L_S
  double settle_stiffness_number = 300;   ///< kappa in K_N -> min(K_N, kappa p d) during settling and repose
  double stress_stiffness_number = 1000;  ///< the same with p = sigma3 in the stress test
  double mass_floor = 0.4;             ///< grains smaller than this share of L_S carry the mass of that size
  double step_fraction = 0.15;         ///< share of sqrt(m/K) taken as the step
  double most_damping_ratio = 0;       ///< contacts damped beyond this share of critical count as damped by it; 0 = as given
  double isotropic_servo_steps = 50;   ///< steps in which the walls answer during the isotropic part of the stress test; few shake the specimen
  double inertial_number = 1e-2;       ///< sets the axial strain rate of the stress test, and the plate's speed
  double axial_strain = 0.20;          ///< end of the stress test

  bool operator==(const Numerics&) const = default;
};

struct StageSpec {
  StageKind kind = StageKind::kSettle;
  Micro micro;
  Numerics numerics;
  std::uint64_t seed = 1;
  double confining_stress = 0;         ///< sigma3 [Pa], stress stages only
  PlateSize plate;                     ///< penetration stages only
  EffectSet effects;                     ///< of those, only acting_in(kind) are meant

  bool operator==(const StageSpec&) const = default;
};

/// True for every stage that starts from the settled bed (and so has the settle stage as its parent).
inline bool needs_bed(StageKind kind) { return kind != StageKind::kSettle; }

/// The settle stage whose bed this stage starts from.
inline StageSpec parent_of(StageSpec spec) {
  spec.kind = StageKind::kSettle;
  spec.effects = acting_in(spec.effects, spec.kind);
  spec.confining_stress = 0;
  spec.plate = {};
  return spec;
}

}  // namespace regolab
