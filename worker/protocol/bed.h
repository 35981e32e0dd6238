/// A specimen: the world and what every test wants to know of it. All lengths [m].
#pragma once
#include <string>

#include "vocab/stage.h"
#include "worker/dem/world.h"

namespace regolab::protocol {

struct Bed {
  dem::World world;
  Micro micro;
  double length = 0;          ///< L of the box
  double width = 0;           ///< W of the box
  double solid_volume = 0;    ///< V_P, of all clusters [m3]
  double step_fraction = 0.15;
  double most_damping_ratio = 0;  ///< see LinearLaw
  EffectSet effects;              ///< of the stage that has the bed; not saved: each stage says its own

  double mean_diameter() const { return 0.6 * micro.largest_diameter; }
  /// Half the bed's weight per area, solid: the pressure that sets the softened stiffness of settling and repose [Pa].
  double pressure() const { return 0.5 * micro.grain_density * micro.gravity * solid_volume / (0.52 * length * width); }

  /// eta of a contact between a cluster of mean mass and a wall [N s/m].
  double wall_dashpot() const;

  template <class A>
  void archive(A& ar) {
    ar(world, micro.friction_angle, micro.normal_stiffness, micro.normal_damping, micro.tangential_stiffness,
       micro.tangential_damping, micro.largest_diameter, micro.kind, micro.rotation, micro.damping_unit, micro.grain_density,
       micro.gravity, length, width, solid_volume, step_fraction, most_damping_ratio);
  }
};

/// The contact law with K_N -> min(K_N, most), K_T in the same ratio and eta with the root of the factor, so the damping ratio
/// stays [protocols, section 3]. most <= 0 keeps the true stiffness.
dem::LinearLaw softened_law(const Bed& bed, double most);

/// That of settling and repose under `gravity` times the ratio: softened for the bed's own weight.
dem::LinearLaw settling_law(const Bed& bed, double settle_stiffness_number, double gravity_ratio);

/// Random generation and replacement under the settings of `spec`; empty text, or why there is no bed.
std::string generate_bed(const StageSpec& spec, Bed& bed);

/// The step after a change of law, from the bed's own fraction.
void renew_step(Bed& bed);

}  // namespace regolab::protocol
