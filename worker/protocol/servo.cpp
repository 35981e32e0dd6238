#include "worker/protocol/servo.h"

#include <algorithm>

namespace regolab::protocol {

double opening(const dem::Walls& walls, int axis) { return walls[2 * axis + 1].position - walls[2 * axis].position; }

double area_across(const dem::Walls& walls, int axis) {
  return opening(walls, (axis + 1) % 3) * opening(walls, (axis + 2) % 3);
}

double mean_stress(const dem::Walls& walls, int axis) {
  return 0.5 * (walls[2 * axis].force + walls[2 * axis + 1].force) / area_across(walls, axis);
}

void hold_stress(const Servo& servo, int axis, double& drift, dem::World& world) {
  constexpr double kFewestContacts = 5;  // a bare wall still approaches at a bounded gain
  dem::Wall& low = world.walls[2 * axis];
  dem::Wall& high = world.walls[2 * axis + 1];
  const double contacts = std::max(kFewestContacts, 0.5 * (low.contacts + high.contacts));
  const double excess = (mean_stress(world.walls, axis) - servo.wanted) * area_across(world.walls, axis);
  const double proportional = excess / (world.law.normal_stiffness * contacts * servo.time_steps * world.dt);
  const double speed = proportional + drift;
  const double outward = std::clamp(speed, -servo.most_speed, servo.most_speed);
  if (outward == speed) drift += proportional / servo.integral_steps;  // a wall at its cap does not wind up
  low.velocity = -outward;
  high.velocity = outward;
}

}  // namespace regolab::protocol
