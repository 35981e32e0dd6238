/// Attraction of grains in touch or nearly so: F_c = c* d^2 with d the harmonic mean diameter, d = 4 R*. It follows from a potential, so
/// it takes and gives back the same work; Coulomb's cap stands on the push alone, F_n + F_c.
#pragma once
#include <algorithm>
#include <cmath>

#include "worker/dem/laws/contact_effects.h"
#include "worker/dem/simd/pack.h"

namespace regolab::dem {

/// [N]. Constant in touch and falling to 0 over the range r = 0.02 d; or, the `jkr` variant, F_c sqrt(1 + u/r): the neck that holds the
/// grains widens as they are pressed, and is gone at u = -r.
template <class Real>
REGOLAB_INLINE Real attraction(const ContactEffects& effects, const Real& overlap, const Real& reduced_radius) {
  const Real zero{}, one = zero + 1.0;
  const Real d = 4.0 * reduced_radius, near = one + overlap / (kAttractionRange * d);
  const Real held = select(near > zero, near, zero);
  return effects.cohesion * (d * d) * (effects.jkr ? root(held) : select(held < one, held, one));
}

/// Work to take the grains apart from there, negative [J].
inline double attraction_energy(const ContactEffects& effects, double overlap, double reduced_radius) {
  const double d = 4 * reduced_radius, range = kAttractionRange * d, held = std::max(0.0, 1 + overlap / range);
  const double force = effects.cohesion * d * d;
  if (effects.jkr) return -force * range * held * std::sqrt(held) / 1.5;
  return -force * range * (held < 1 ? 0.5 * held * held : held - 0.5);
}

}  // namespace regolab::dem
