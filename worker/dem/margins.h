/// How far each cluster may travel before the near lists must be looked at again.
#pragma once
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/simd/hot.h"

namespace regolab::dem {

/// Near lists hold every pair closer than the two margins together, so they serve until some cluster's path is longer than its own
/// margin. A path adds up the speeds of the cluster's fastest sphere: it never falls short of the displacement.
struct Margins {
  static constexpr double kSteps = 100;  ///< that a margin lasts at the present speed: fewer look too often, more list too many
  std::vector<double> margin;  // [n] [m]
  std::vector<double> path;    // [n] since the lists were made [m]
  bool anything_swings = true; ///< false when every cluster is one sphere: then turns move nothing

  /// From the present speeds: long enough for kSteps, within [least, most] [m].
  void renew(const Bodies& bodies, double dt, double least, double most);
};

/// Bound on the speed of any sphere centre of a cluster, from the squares of its speeds [m/s]: (a + b)^2 <= 2 (a^2 + b^2).
template <class Real>
REGOLAB_INLINE Real fastest_point2(const Real& v2, const Real& w2, const Real& swing) {
  return 2.0 * (v2 + swing * swing * w2);
}

}  // namespace regolab::dem
