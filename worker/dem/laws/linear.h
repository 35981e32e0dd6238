/// Linear spring and dashpot, normal and tangential, with Coulomb's cap [article Sec. 2.1, Fig. 2 left, Eq. 1; protocols 2].
#pragma once
#include <cmath>

#include "worker/dem/hot.h"

namespace regolab::dem {

/// SI. `root_mass` of a contact is 1 when eta is absolute; sqrt(m_eff) when eta is a ratio, and then the damping constants
/// here are 2 zeta sqrt(K), so that their product is 2 zeta sqrt(m_eff K) in N s/m.
struct LinearLaw {
  double normal_stiffness = 0;      ///< K_N [N/m]
  double normal_damping = 0;        ///< eta_N
  double tangential_stiffness = 0;  ///< K_T [N/m]
  double tangential_damping = 0;    ///< eta_T
  double friction = 0;              ///< tan(theta_F) between grains
  bool damping_is_ratio = false;

  template <class A>
  void archive(A& ar) {
    ar(normal_stiffness, normal_damping, tangential_stiffness, tangential_damping, friction, damping_is_ratio);
  }
};

/// One contact's numbers. n points from b to a; v is the velocity of a relative to b at the contact point; f acts on a.
struct ContactPoint {
  double nx, ny, nz, overlap;
  double vx, vy, vz;
  double sx, sy, sz;          ///< tangential spring: in, as left by the last step; out, advanced
  double fx, fy, fz;          ///< out
};

inline constexpr double kTiny = 1e-300;  ///< keeps a division finite without a branch

/// Never pulls. The spring turns with the tangent plane and keeps its length; while sliding the whole tangential force is at
/// the cap and the spring is cut back to it (the dashpot is off). Selects, no branches: loops over contacts vectorise.
REGOLAB_INLINE void linear_contact(const LinearLaw& law, double friction, double root_mass, double dt, ContactPoint& c) noexcept {
  const double vn = c.vx * c.nx + c.vy * c.ny + c.vz * c.nz;
  const double pushed = law.normal_stiffness * c.overlap - law.normal_damping * root_mass * vn;
  const double fn = pushed > 0.0 ? pushed : 0.0;
  const double ux = c.vx - vn * c.nx, uy = c.vy - vn * c.ny, uz = c.vz - vn * c.nz;

  const double along = c.sx * c.nx + c.sy * c.ny + c.sz * c.nz;
  const double px = c.sx - along * c.nx, py = c.sy - along * c.ny, pz = c.sz - along * c.nz;
  const double before = c.sx * c.sx + c.sy * c.sy + c.sz * c.sz;
  const double after = px * px + py * py + pz * pz;
  const double keep = std::sqrt(before / (after > kTiny ? after : kTiny));
  const double sx = px * keep + ux * dt, sy = py * keep + uy * dt, sz = pz * keep + uz * dt;

  const double damping = law.tangential_damping * root_mass;
  const double tx = -law.tangential_stiffness * sx - damping * ux;
  const double ty = -law.tangential_stiffness * sy - damping * uy;
  const double tz = -law.tangential_stiffness * sz - damping * uz;
  const double size2 = tx * tx + ty * ty + tz * tz;
  const double cap = friction * fn;
  const bool slides = size2 > cap * cap;
  const double to_cap = cap / std::sqrt(size2 > kTiny ? size2 : kTiny);
  const double cut = slides ? to_cap : 1.0;
  const double back = -1.0 / law.tangential_stiffness;
  c.sx = slides ? back * cut * tx : sx;
  c.sy = slides ? back * cut * ty : sy;
  c.sz = slides ? back * cut * tz : sz;
  c.fx = fn * c.nx + cut * tx;
  c.fy = fn * c.ny + cut * ty;
  c.fz = fn * c.nz + cut * tz;
}

}  // namespace regolab::dem
