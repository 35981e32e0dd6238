/// Many clusters in a closed box, for checks of balance, symmetry and determinism.
#pragma once
#include <cstdint>

#include "support/small_world.h"

namespace regolab::test {

struct Swarm {
  int clusters = 60;
  std::uint64_t seed = 1;
  double speed = 0.3;     ///< largest, of each component [m/s]
  double friction = 0.4;  ///< tan, between grains and with walls
  double damping = 0.1;   ///< share of critical, normal and tangential
  double gravity = 0;     ///< [m/s2]
};

/// A mixture of 2-, 4- and 6-sphere clusters (parents 2 to 8 mm) at random in a closed box of 4 x 4 x 4 cm, flying and
/// spinning; the same for the same settings.
World swarm(const Swarm& settings);

/// `clusters` of a swarm pressed by slowly closing smooth walls until they carry force, then brought to rest. `friction`
/// (tan) is that between grains.
World pressed_packing(int clusters, double friction);

}  // namespace regolab::test
