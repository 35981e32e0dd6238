/// The linear contact law a second time, as a textbook writes it: vectors, branches and roots, one contact at a time. Slow and plain:
/// the engine's law is tested against it, so it shares no arithmetic with worker/dem/laws/linear.h.
#pragma once
#include "support/small_world.h"

namespace regolab::test {

struct PlainLaw {
  double normal_stiffness = 0;      ///< K_N [N/m]
  double tangential_stiffness = 0;  ///< K_T [N/m]
  double normal_damping = 0;        ///< a share of critical, or N s/m
  double tangential_damping = 0;
  bool damping_is_ratio = false;
  double most_damping_ratio = 0;    ///< share of critical; 0 = no cap
};

/// The same law in the engine's words.
dem::LinearLaw engine_law(const PlainLaw& law, double friction = 0);

/// One contact: the normal points to the grain on which the force acts, the velocity is that grain's relative to the other side.
struct PlainTouch {
  Vec3 normal;
  double overlap = 0;  ///< [m]
  Vec3 velocity;       ///< [m/s]
  Vec3 spring;         ///< as the last step left it [m]
  double friction = 0; ///< tan
  double mass = 0;     ///< effective [kg]
};
struct PlainAnswer {
  Vec3 force;   ///< [N]
  Vec3 spring;  ///< [m]
  bool capped = false, would_pull = false, slides = false;
};
PlainAnswer plain_contact(const PlainLaw& law, double dt, const PlainTouch& touch);

}  // namespace regolab::test
