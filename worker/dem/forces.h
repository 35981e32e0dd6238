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

/// Springs and forces into their slots, and forces and torques onto the clusters in slot order. Without `loads` they
/// stay in the slots (which keep loads then): threads share the work, and sum_loads() adds up.
void press_pairs(const ForceInput& in, Stretch stretch, Slots& slots, Load* loads);
void press_walls(const ForceInput& in, const Walls& walls, Stretch stretch, Slots& slots, Load* loads);

/// Which slots load a cluster, in the order in which one thread would add them.
struct Shares {
  std::vector<std::int32_t> first;  // [n + 1]
  std::vector<std::int32_t> slot;   // pairs: 2 slot (as a) or 2 slot + 1 (as b); walls: -1 - slot
};
void list_shares(const Slots& pairs, const Slots& walls, std::size_t n_bodies, Shares& shares);

/// Loads of a stretch of clusters from those that the slots keep: the same bits as on one thread.
void sum_loads(const Shares& shares, const Slots& pairs, const Slots& walls, Stretch bodies, std::vector<Load>& loads);

/// The walls' own force, shear and contacts from their slots, one after the other.
void sum_wall_forces(const Slots& slots, Walls& walls);

}  // namespace regolab::dem
