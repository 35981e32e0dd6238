/// One step of the world.
#pragma once
#include "worker/dem/world.h"

namespace regolab::dem {

/// Positions advance by dt with the forces of the last step, then forces are computed anew at the new positions.
void step(World& world);

/// Forces at the present positions without moving anything: the start of a run, or after a change of law or walls.
void compute_forces(World& world);

/// The phases of a step, in order, as the benchmark names them.
bool kick_and_drift(World& world);   ///< true when a cluster or a wall left its margin
void refresh_lists(World& world);    ///< near slots from the pair list; that too when its skin is used up
void place_balls(World& world);
void press_pairs(World& world);
void press_walls(World& world);
void add_crossings(World& world);    ///< loads between slabs of a large bed

}  // namespace regolab::dem
