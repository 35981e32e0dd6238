/// Contact forces of the near slots: measure, apply the law, add. Masks, no branches on what touches.
#pragma once
#include "worker/dem/laws/linear.h"
#include "worker/dem/near_list.h"

namespace regolab::dem {

/// What the forces of a step need besides the slots.
struct ForceInput {
  const LinearLaw& law;
  double dt;              ///< [s]
  const Balls& balls;
  const Bodies& bodies;   ///< their motion, as the integrator published it
};

/// Where the loads of a stretch of slots go.
struct LoadTarget {
  Load* clusters;  ///< [n]
  Load* cells;     ///< of the crossings
};

/// Springs and forces into their slots, and forces and torques onto the clusters, or into the cells of crossings, in slot order.
void press_pairs(const ForceInput& in, Stretch stretch, Slots& slots, LoadTarget target);
void press_walls(const ForceInput& in, const Walls& walls, Stretch stretch, Slots& slots, LoadTarget target);

/// The walls' own force, shear and contacts from their slots, one after the other.
void sum_wall_forces(const Slots& slots, Walls& walls);

}  // namespace regolab::dem
