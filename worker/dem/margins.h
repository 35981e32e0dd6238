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
  bool anything_swings = true; ///< false when every cluster is one sphere: then turns move nothing
};

/// Distance for each cluster to go in `time` at its own speed and the bed's together, within [least, most] [m].
struct Travel {
  double time = 0;             ///< [s]
  double least = 0, most = 0;  ///< [m]
};
void allow(const Bodies& bodies, const Travel& travel, std::vector<double>& distance);

/// How many steps a list should last at the present speeds. Steered: a list that lasts is long, and holds much that is of no use; a
/// short one costs searches. Does not show in the results.
struct Lasting {
  double steps, low, high;   ///< asked for, and its bounds
  int fewest;                ///< a list that lasted less is lengthened
  std::int64_t made_at = 0;  ///< step
  /// `burden` is the share of what the list held that was of no use; above `high_burden` the next list is shorter, below `low_burden`
  /// longer.
  void renew(std::int64_t step, double burden, double low_burden, double high_burden);
};

/// Bound on the speed of any sphere centre of a cluster, from the squares of its speeds [m/s]: (a + b)^2 <= 2 (a^2 + b^2).
template <class Real>
REGOLAB_INLINE Real fastest_point2(const Real& v2, const Real& w2, const Real& swing) {
  return 2.0 * (v2 + swing * swing * w2);
}

}  // namespace regolab::dem
