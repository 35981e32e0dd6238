/// Elastic-plastic spring against rolling [Ai and others 2011, EPSD; Iwashita and Oda 1998]: the twin of the tangential spring, with an
/// angle for its stretch, k_r for K_T and mu_r R* F_n for the cap. R* is the reduced radius of the two spheres that touch, R at a wall.
#pragma once
#include "worker/dem/laws/linear.h"

namespace regolab::dem {

/// w: angular velocity of a relative to b; r: rolling angle, in as left by the last step, out advanced; m: moment on a.
template <class Real>
struct RollingSpring {
  Real wx, wy, wz;
  Real rx, ry, rz;
  Real mx{}, my{}, mz{};
};

/// k_r [N m]: 2.25 K_N (mu_r R*)^2, or K_T R*^2.
template <class Real, class Stiffness>
REGOLAB_INLINE Real rolling_stiffness(const ContactEffects& effects, const Stiffness& k, const Real& reduced_radius) {
  const Real square = reduced_radius * reduced_radius;
  if (effects.iwashita_oda) return square * k.tangential;
  return (2.25 * effects.rolling * effects.rolling) * square * k.normal;
}

/// `push`: normal force without attraction [N]. Rolling turns about axes in the tangent plane; spin about the normal meets nothing. The
/// iwashita_oda variant has the tangential dashpot times R*^2 while it does not roll.
template <class Real, class Stiffness>
REGOLAB_INLINE void rolling_moment(const LinearLaw& law, const Stiffness& k, const Real& push, const Real& reduced_radius,
                                   const Real& root_mass, double dt, const ContactPoint<Real>& c, RollingSpring<Real>& r) {
  const Real zero{}, one = zero + 1.0, tiny = zero + kTiny;
  const Real spin = r.wx * c.nx + r.wy * c.ny + r.wz * c.nz;
  const Real ux = r.wx - spin * c.nx, uy = r.wy - spin * c.ny, uz = r.wz - spin * c.nz;
  const Real along = r.rx * c.nx + r.ry * c.ny + r.rz * c.nz;
  const Real length2 = r.rx * r.rx + r.ry * r.ry + r.rz * r.rz;
  const Real tilt2 = along * along / select(length2 > tiny, length2, tiny);
  const Real keep = one + tilt2 * (0.5 + 0.375 * tilt2);  // as the tangential spring turns with its plane
  const Real rx = (r.rx - along * c.nx) * keep + dt * ux, ry = (r.ry - along * c.ny) * keep + dt * uy,
             rz = (r.rz - along * c.nz) * keep + dt * uz;
  const Real stiffness = rolling_stiffness(law.effects, k, reduced_radius);
  const Dashpot dashpot(law, law.tangential_stiffness, law.tangential_damping);
  const Real damping = law.effects.iwashita_oda ? reduced_radius * reduced_radius * k.damped(dashpot.eta(root_mass)) : zero;
  const Real mx = -stiffness * rx - damping * ux, my = -stiffness * ry - damping * uy, mz = -stiffness * rz - damping * uz;
  const Real size2 = mx * mx + my * my + mz * mz, cap = law.effects.rolling * reduced_radius * push;
  const auto rolls = size2 > cap * cap;
  const Real cut = select(rolls, cap / root(select(size2 > tiny, size2, tiny)), one);
  const Real back = -cut / select(stiffness > tiny, stiffness, tiny);
  r.rx = select(rolls, back * mx, rx);
  r.ry = select(rolls, back * my, ry);
  r.rz = select(rolls, back * mz, rz);
  r.mx = cut * mx, r.my = cut * my, r.mz = cut * mz;
}

}  // namespace regolab::dem
