#include "reference_law/plain_law.h"

#include <cmath>

namespace regolab::test {
namespace {

/// eta [N s/m] of a dashpot beside a spring of this stiffness, and whether the cap cut it.
struct Dashpot {
  double eta;
  bool capped;
};
Dashpot dashpot(const PlainLaw& law, double stiffness, double damping, double mass) {
  const double critical = 2 * std::sqrt(mass * stiffness);
  double eta = damping;
  if (law.damping_is_ratio) eta = damping * critical;
  if (law.most_damping_ratio > 0 && eta > law.most_damping_ratio * critical) return {law.most_damping_ratio * critical, true};
  return {eta, false};
}

/// Turned into the plane across `normal`, as long as it was.
Vec3 turned_into_plane(const Vec3& spring, const Vec3& normal) {
  const double before = norm(spring);
  if (before == 0) return spring;
  const Vec3 flat = spring - dot(spring, normal) * normal;
  const double after = norm(flat);
  if (after == 0) return flat;
  return (before / after) * flat;
}

}  // namespace

dem::LinearLaw engine_law(const PlainLaw& law, double friction) {
  dem::LinearLaw out;
  out.normal_stiffness = law.normal_stiffness;
  out.tangential_stiffness = law.tangential_stiffness;
  out.normal_damping = law.normal_damping * (law.damping_is_ratio ? 2 * std::sqrt(law.normal_stiffness) : 1);
  out.tangential_damping = law.tangential_damping * (law.damping_is_ratio ? 2 * std::sqrt(law.tangential_stiffness) : 1);
  out.damping_is_ratio = law.damping_is_ratio;
  out.most_damping_ratio = law.most_damping_ratio;
  out.friction = friction;
  return out;
}

PlainAnswer plain_contact(const PlainLaw& law, double dt, const PlainTouch& touch) {
  const Dashpot normal = dashpot(law, law.normal_stiffness, law.normal_damping, touch.mass);
  const Dashpot tangential = dashpot(law, law.tangential_stiffness, law.tangential_damping, touch.mass);
  PlainAnswer answer;
  answer.capped = normal.capped || tangential.capped;

  const double leaving = dot(touch.velocity, touch.normal);
  double push = law.normal_stiffness * touch.overlap - normal.eta * leaving;
  if (push < 0) {
    push = 0;
    answer.would_pull = true;
  }

  const Vec3 slip = touch.velocity - leaving * touch.normal;
  answer.spring = turned_into_plane(touch.spring, touch.normal) + dt * slip;
  Vec3 drag = -law.tangential_stiffness * answer.spring - tangential.eta * slip;
  const double most = touch.friction * push;
  if (norm(drag) > most) {
    answer.slides = true;
    drag = (most / norm(drag)) * drag;
    answer.spring = (-1 / law.tangential_stiffness) * drag;
  }
  answer.force = push * touch.normal + drag;
  return answer;
}

}  // namespace regolab::test
