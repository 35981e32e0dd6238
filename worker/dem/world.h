/// All state of a simulation; a stage has only settings. What `archive` names is what a checkpoint holds: the rest follows.
#pragma once
#include <cstdint>

#include "worker/dem/bodies.h"
#include "worker/dem/crossings.h"
#include "worker/dem/forces.h"
#include "worker/dem/laws/linear.h"
#include "worker/dem/near_list.h"
#include "worker/dem/pair_list.h"
#include "worker/dem/springs.h"
#include "worker/dem/walls.h"

namespace regolab::dem {

struct World {
  Bodies bodies;
  Spheres spheres;
  Walls walls;
  LinearLaw law;
  double gravity = 0;        ///< magnitude, along -z [m/s2]
  double dt = 0;             ///< [s]
  double drag = 0;           ///< share of velocity and spin taken per second, to quench residual motion [1/s]
  double skin = 0;           ///< of the pair list where little moves [m]
  std::int64_t step = 0;
  double time = 0;           ///< [s]
  double wall_work = 0;      ///< done by moving walls on the grains so far [J]
  int threads = 1;
  bool lists_stale = true;   ///< set it after adding clusters, or taking them away

  // Follows from the state; not saved, and not seen in the results.
  PairList pairs;            ///< within the clusters' allowances
  Margins margins;
  Lasting near_lists{.steps = 30, .low = 4, .high = 500};
  Lasting pair_lists{.steps = 300, .low = 50, .high = 5000};
  double wall_margin = 0;    ///< [m]
  std::array<double, kWallIds> walls_at_refresh{};  ///< [m]
  Slots near_pairs, near_walls;
  Balls balls;
  Crossings crossings;
  std::size_t slabs = 0;     ///< that the bed is cut into; 0: by its size
  Centres centres;           ///< of the last refresh
  Springs pair_springs, wall_springs;  ///< between two sets of slots, and in checkpoints
  std::int64_t list_builds = 0, refreshes = 0, refreshes_at_build = 0;

  /// Without the plate: see Walls.
  template <class A>
  void archive(A& ar) {
    if constexpr (!A::kLoading) hold_springs();
    ar(bodies, spheres, walls, law, gravity, dt, drag, skin, step, time, wall_work, pair_springs, wall_springs);
    if (law.effects.rolling > 0) pair_springs.archive_rolling(ar), wall_springs.archive_rolling(ar);
    if constexpr (A::kLoading) {
      publish_motion(bodies);
      lists_stale = true;
    }
  }

  /// Copies the springs out of the slots, where the slots have them.
  void hold_springs() {
    if (near_pairs.hold_springs) take_springs(near_pairs, pair_springs);
    if (near_walls.hold_springs) take_springs(near_walls, wall_springs);
  }
};

}  // namespace regolab::dem
