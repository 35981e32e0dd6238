/// Springs that stiffen with the root of the overlap: F = K u ((1 - h) + h sqrt(u/u_0)); h = 1 is Hertz's law with one constant for all
/// contacts, and with K_T in proportion to sqrt(u) Mindlin's without slip. At u_0 both springs are those of the linear law.
#pragma once
#include <cmath>

#include "worker/dem/laws/linear.h"

namespace regolab::dem {

template <class Real>
struct Stiffened {
  Real normal, tangential;  ///< secants: F = normal * u [N/m]
  Real root_tangent;        ///< root of the tangent of F over K: dashpots keep their share of critical

  REGOLAB_INLINE Real damped(const Real& eta) const { return root_tangent * eta; }
};

/// Of contacts with this overlap; where it is not positive, that of first touch, with a trace of tangential stiffness to divide by.
template <class Real>
REGOLAB_INLINE Stiffened<Real> stiffened(const LinearLaw& law, const Real& overlap) {
  constexpr double kTrace = 1e-9;
  const double h = law.effects.hertz;
  const Real zero{}, touching = select(overlap > zero, overlap, zero);
  const Real stretch = root((1.0 / law.effects.hertz_overlap) * touching);
  const Real secant = (1.0 - h) + h * stretch, tangent = (1.0 - h) + 1.5 * h * stretch;
  return {law.normal_stiffness * secant, law.tangential_stiffness * (secant + kTrace), root(tangent)};
}

/// Of the stiffest contact that the step reckons with, over K; 1 for linear springs.
inline double step_stiffening(const LinearLaw& law) {
  return 1 + law.effects.hertz * (1.5 * std::sqrt(law.effects.hertz_most) - 1);
}

/// Of the normal spring [J].
inline double normal_energy(const LinearLaw& law, double overlap) {
  const double h = law.effects.hertz, linear = 0.5 * law.normal_stiffness * overlap * overlap;
  return h > 0 ? linear * ((1 - h) + 0.8 * h * std::sqrt(overlap / law.effects.hertz_overlap)) : linear;
}

}  // namespace regolab::dem
