/// All state of a simulation; a stage has only settings. What stands here is what a checkpoint holds.
#pragma once
#include <cstdint>

#include "worker/dem/bodies.h"
#include "worker/dem/contacts.h"
#include "worker/dem/laws/linear.h"
#include "worker/dem/pair_list.h"
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
  double skin = 0;           ///< of the near lists [m]
  std::int64_t step = 0;
  double time = 0;           ///< [s]
  double wall_work = 0;      ///< done by moving walls on the grains so far [J]

  PairList pairs;
  Poses at_build;            ///< where the clusters were when the lists were built
  bool lists_stale = true;

  // Derived each step; not saved.
  Contacts contacts, wall_contacts;
  CellGrid grid;
  int threads = 1;
  std::int64_t list_builds = 0;

  template <class A>
  void archive(A& ar) {
    ar(bodies, spheres, walls, law, gravity, dt, drag, skin, step, time, wall_work, pairs, at_build, lists_stale);
  }
};

}  // namespace regolab::dem
