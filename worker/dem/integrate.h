/// Leapfrog: velocities and angular momenta at half steps, positions and turns at whole steps. Second order.
#pragma once
#include "worker/dem/bodies.h"

namespace regolab::dem {

/// v += (f/m + g) dt, x += v dt; L += t dt, and the turn by the angular velocity at the middle of the step. Angular momentum
/// is kept in space, so a free cluster conserves it exactly. Leaves fx..tz as they are; held clusters stay. `drag` [1/s].
void kick_and_drift(double gravity, double drag, double dt, Bodies& bodies);

void clear_forces(Bodies& bodies);

}  // namespace regolab::dem
