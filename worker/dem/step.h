/// One step of the world.
#pragma once
#include "worker/dem/world.h"

namespace regolab::dem {

/// Positions advance by dt with the forces of the last step, then forces are computed anew at the new positions.
void step(World& world);

/// Forces at the present positions without moving anything: the start of a run, or after a change of law or walls.
void compute_forces(World& world);

/// Contacts and lists anew from the present positions (history is kept).
void rebuild_lists(World& world);

}  // namespace regolab::dem
