/// The clusters' step: leapfrog for the centres, angular momentum kept in space, the turn by the midpoint rule.
#pragma once
#include "worker/dem/bodies.h"
#include "worker/dem/margins.h"

namespace regolab::dem {

struct Kick {
  double gravity = 0;  ///< along -z [m/s2]
  double keep = 1;     ///< share of velocity and angular momentum that drag leaves
  double dt = 0;       ///< [s]
};

/// A stretch of clusters: velocities by the loads of the last step, then positions and turns; publishes motion and placing, takes
/// the loads back to zero. True when one of them left its margin.
bool kick_and_drift(const Kick& kick, Stretch stretch, Bodies& bodies, Margins& margins);

}  // namespace regolab::dem
