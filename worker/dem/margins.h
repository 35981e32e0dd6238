/// How far each cluster may travel before the near lists must be looked at again.
#pragma once
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/simd/hot.h"

namespace regolab::dem {

/// Near lists hold every pair closer than the two margins together, so they serve until some cluster's path is longer than its own
/// margin. A path adds up the speeds of the cluster's fastest sphere: it never falls short of the displacement.
struct Margins {
  std::vector<double> margin;  // [n] [m]
  std::vector<double> path;    // [n] since the lists were made [m]
  double attraction = 0;       ///< how far apart spheres may attract one another [m]
  bool anything_swings = true; ///< false when every cluster is one sphere: then turns move nothing
};

/// Distance for each cluster to go in `time` at its own speed and the bed's together, within [least, most] [m].
struct Travel {
  double time = 0;             ///< [s]
  double least = 0, most = 0;  ///< [m]
};
void allow(const Bodies& bodies, const Travel& travel, std::vector<double>& distance);

/// How many steps a list should last at the present speeds: long lists hold much that is of no use, short ones cost searches. Sought by
/// going up or down as long as the work per step falls. Counts, not clocks; and no results depend on it.
struct Lasting {
  double steps, low, high;   ///< asked for, and its bounds
  double factor = 1.25;      ///< of the next change
  double cost_before = 0;    ///< work per step of the list before
  std::int64_t made_at = 0;  ///< step

  /// `held` is the work that the list made in each step, `search` that of making it, in the same unit.
  void renew(std::int64_t step, double held, double search);
};

/// Bound on the speed of any sphere centre of a cluster, from the squares of its speeds [m/s]: (a + b)^2 <= 2 (a^2 + b^2).
template <class Real>
REGOLAB_INLINE Real fastest_point2(const Real& v2, const Real& w2, const Real& swing) {
  return 2.0 * (v2 + swing * swing * w2);
}

}  // namespace regolab::dem
