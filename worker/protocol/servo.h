/// Walls that hold a stress: each pair of opposite walls moves until its mean stress is the wanted one [protocols, section 7].
#pragma once
#include "worker/protocol/bed.h"

namespace regolab::protocol {

/// Speed of each wall of a pair, outward when positive: P + I. P follows (measured - wanted) A / (K N_c tau), which answers the springs
/// at the wall, with a lag: a dashpot answers a wall's speed at once, and without the lag walls on strongly damped contacts swing
/// between their caps for ever. I is the slow mean of P, without which the stress lags behind a steady deformation: with P alone and
/// tau of 50 steps the lateral stress stood 60 % too high at an inertial number of 0.01. A cap too low makes a false cohesion.
struct Servo {
  double wanted = 0;            ///< [Pa]
  double most_speed = 0;        ///< cap of each wall's speed [m/s]
  double dashpot = 0;           ///< eta of a contact at the wall [N s/m]
  double time_steps = 50;       ///< tau / dt
  double integral_times = 10;   ///< time of the integral part over tau and the lag
};

/// What a servo remembers from step to step: its two parts [m/s].
struct ServoParts {
  double proportional = 0, integral = 0;
  template <class A>
  void archive(A& ar) { ar(proportional, integral); }
};

/// Distance between the walls of an axis [m], and the area of one of them [m2].
double opening(const dem::Walls& walls, int axis);
double area_across(const dem::Walls& walls, int axis);
/// Mean of the two wall forces over the present area [Pa].
double mean_stress(const dem::Walls& walls, int axis);

/// Sets the speeds of the two walls of `axis`.
void hold_stress(const Servo& servo, int axis, ServoParts& parts, dem::World& world);

}  // namespace regolab::protocol
