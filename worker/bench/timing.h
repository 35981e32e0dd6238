/// What steps cost: processor time, which stays true on a busy machine, and wall time, which threads need.
#pragma once
#include "worker/dem/world.h"

namespace regolab::bench {

struct StepCost {
  double wall_us = 0;  ///< per step [us]
  double cpu_us = 0;   ///< per step, all threads [us]
};

struct TouchCount {
  long grains = 0;  ///< touching pairs of spheres
  long walls = 0;   ///< spheres touching a wall, once per wall
};

/// Steps `warm_up` times, then times `steps` steps.
StepCost time_steps(int warm_up, int steps, dem::World& world);

/// What touched in the last step.
TouchCount touches(const dem::World& world);

}  // namespace regolab::bench
