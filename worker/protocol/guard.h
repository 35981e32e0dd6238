/// The watch on every run: overlap, energy, finiteness, lost clusters. What it finds is stored as the reason.
#pragma once
#include <optional>

#include "worker/protocol/test.h"

namespace regolab::protocol {

/// Mechanical energy may fall, and rise only by the work of moving walls.
struct Guard {
  double allowance = 0;   ///< energy at the start plus later corrections [J]
  double scale = 0;       ///< largest kinetic + elastic energy seen, and that of attraction [J]
  double worst_gain = 0;  ///< largest excess over the allowance, as a share of the scale
  double deepest = 0;     ///< largest overlap over the smaller radius, at looks

  /// Starts, or starts over, from the world as it is.
  void begin(const dem::World& world);
  /// Call before and after a change that is not mechanics (clusters fixed or taken away, stiffness changed).
  void excuse(double energy_before, double energy_after) { allowance += energy_after - energy_before; }
  /// Looks at the world; `margin` is how far outside the box a centre may be [m].
  std::optional<Ending> look(const Bed& bed, double margin);

  template <class A>
  void archive(A& ar) { ar(allowance, scale, worst_gain, deepest); }
};

}  // namespace regolab::protocol
