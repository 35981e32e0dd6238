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

void hold_stress(const Servo& servo, int axis, ServoParts& parts, dem::World& world) {
  constexpr double kFewestContacts = 5;  // a bare wall still approaches at a bounded gain
  constexpr double kLag = 2;             // a dashpot's answer is halved from step to step
  dem::Wall& low = world.walls[2 * axis];
  dem::Wall& high = world.walls[2 * axis + 1];
  const double contacts = std::max(kFewestContacts, 0.5 * (low.contacts + high.contacts));
  const double excess = (mean_stress(world.walls, axis) - servo.wanted) * area_across(world.walls, axis);
  const double stiffness = dem::at_walls(world.law).normal_stiffness, tau = servo.time_steps * world.dt;
  const double lag = std::max(1.0, kLag * servo.dashpot / (stiffness * tau));  // [steps]
  const auto capped = [&](double speed) { return std::clamp(speed, -servo.most_speed, servo.most_speed); };
  parts.proportional += (capped(excess / (stiffness * contacts * tau)) - parts.proportional) / lag;
  const double speed = parts.proportional + parts.integral, outward = capped(speed);
  // A wall at its cap does not wind up.
  if (outward == speed) parts.integral += parts.proportional / (servo.integral_times * (servo.time_steps + lag));
  low.velocity = -outward;
  high.velocity = outward;
}

}  // namespace regolab::protocol
