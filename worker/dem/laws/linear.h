/// Linear spring and dashpot, normal and tangential, with Coulomb's cap [article Sec. 2.1, Fig. 2 left, Eq. 1; protocols 2].
#pragma once
#include <cstdint>

#include "worker/dem/laws/contact_effects.h"
#include "worker/dem/simd/pack.h"

namespace regolab::dem {

/// SI. When eta is a ratio the damping constants here are 2 zeta sqrt(K), so that times the root of a contact's effective mass they
/// are 2 zeta sqrt(m_eff K) in N s/m.
struct LinearLaw {
  double normal_stiffness = 0;      ///< K_N [N/m]
  double normal_damping = 0;        ///< eta_N
  double tangential_stiffness = 0;  ///< K_T [N/m]
  double tangential_damping = 0;    ///< eta_T
  double friction = 0;              ///< tan(theta_F) between grains
  bool damping_is_ratio = false;
  /// Contacts damped beyond this share of critical count as damped by it; 0 = as given. A dead collision stays dead, and the
  /// smallest grains' dashpots no longer set the step.
  double most_damping_ratio = 0;
  ContactEffects effects;

  /// The second bit beside `damping_is_ratio` says that effects follow: without any, bytes are those of laws that knew none.
  template <class A>
  void archive(A& ar) {
    auto flags = static_cast<std::uint8_t>((damping_is_ratio ? 1 : 0) | (effects.any() ? 2 : 0));
    ar(normal_stiffness, normal_damping, tangential_stiffness, tangential_damping, friction, flags, most_damping_ratio);
    damping_is_ratio = (flags & 1) != 0;
    if ((flags & 2) != 0) {
      ar(effects);
    } else if (A::kLoading) {
      effects = {};
    }
  }
};

/// One contact's numbers, or four of them. n points from b to a; v is the velocity of a relative to b at the contact point; f
/// acts on a.
template <class Real>
struct ContactPoint {
  Real nx, ny, nz, overlap;
  Real vx, vy, vz;
  Real sx, sy, sz;          ///< tangential spring: in, as left by the last step; out, advanced
  Real fx{}, fy{}, fz{};    ///< out
};

/// eta of a dashpot as a function of the root of the contact's effective mass: min(plain + per_root * root, most * root) [N s/m].
struct Dashpot {
  double plain, per_root, most;
  Dashpot(const LinearLaw& law, double stiffness, double damping)
      : plain(law.damping_is_ratio ? 0.0 : damping), per_root(law.damping_is_ratio ? damping : 0.0),
        most(law.most_damping_ratio > 0 ? 2 * law.most_damping_ratio * std::sqrt(stiffness) : kUnlimited) {}
  template <class Real>
  REGOLAB_INLINE Real eta(const Real& root_mass) const {
    const Real asked = plain + per_root * root_mass, limit = most * root_mass;
    return select(asked < limit, asked, limit);
  }
  static constexpr double kUnlimited = 1e300;
};

inline constexpr double kTiny = 1e-300;  ///< keeps a division finite without a branch

/// The springs' constants as the law takes them: the same for all contacts.
struct Constant {
  double normal, tangential;  ///< [N/m]
  template <class Real>
  REGOLAB_INLINE const Real& damped(const Real& eta) const { return eta; }
};

/// Never pulls. The spring turns with the tangent plane and keeps its length; while sliding the whole tangential force is at
/// the cap and the spring is cut back to it (the dashpot is off). Selects, no branches.
template <class Real, class Stiffness>
REGOLAB_INLINE void contact_with(const LinearLaw& law, const Stiffness& k, const Real& friction, const Real& root_mass, double dt,
                                 ContactPoint<Real>& c) noexcept {
  const Dashpot normal(law, law.normal_stiffness, law.normal_damping), tangential(law, law.tangential_stiffness, law.tangential_damping);
  const Real zero{}, one = zero + 1.0, tiny = zero + kTiny;
  const Real vn = c.vx * c.nx + c.vy * c.ny + c.vz * c.nz;
  const Real pushed = k.normal * c.overlap - k.damped(normal.eta(root_mass)) * vn;
  const Real fn = select(pushed > zero, pushed, zero);
  const Real ux = c.vx - vn * c.nx, uy = c.vy - vn * c.ny, uz = c.vz - vn * c.nz;

  const Real along = c.sx * c.nx + c.sy * c.ny + c.sz * c.nz;
  const Real length2 = c.sx * c.sx + c.sy * c.sy + c.sz * c.sz;
  const Real tilt2 = along * along / select(length2 > tiny, length2, tiny);  // sine squared out of the tangent plane
  const Real keep = one + tilt2 * (0.5 + 0.375 * tilt2);  // 1/sqrt(1 - tilt2), to round-off below 3 mrad a step
  const Real sx = (c.sx - along * c.nx) * keep + dt * ux, sy = (c.sy - along * c.ny) * keep + dt * uy,
             sz = (c.sz - along * c.nz) * keep + dt * uz;

  const Real damping = k.damped(tangential.eta(root_mass));
  const Real tx = -k.tangential * sx - damping * ux;
  const Real ty = -k.tangential * sy - damping * uy;
  const Real tz = -k.tangential * sz - damping * uz;
  const Real size2 = tx * tx + ty * ty + tz * tz;
  const Real cap = friction * fn;
  const auto slides = size2 > cap * cap;
  const Real cut = select(slides, cap / root(select(size2 > tiny, size2, tiny)), one);
  const auto compliance = -1.0 / k.tangential;
  c.sx = select(slides, compliance * cut * tx, sx);
  c.sy = select(slides, compliance * cut * ty, sy);
  c.sz = select(slides, compliance * cut * tz, sz);
  c.fx = fn * c.nx + cut * tx;
  c.fy = fn * c.ny + cut * ty;
  c.fz = fn * c.nz + cut * tz;
}

template <class Real>
REGOLAB_INLINE void linear_contact(const LinearLaw& law, const Real& friction, const Real& root_mass, double dt,
                                   ContactPoint<Real>& c) noexcept {
  contact_with(law, Constant{law.normal_stiffness, law.tangential_stiffness}, friction, root_mass, dt, c);
}

/// The law of contacts with walls: softer where they give way, with dashpots at the same share of critical.
inline LinearLaw at_walls(const LinearLaw& law) {
  LinearLaw wall = law;
  wall.effects.cohesion = 0;
  if (!(law.effects.wall_compliance > 0)) return wall;
  const double softer = 1 / (1 + law.effects.wall_compliance), root_softer = std::sqrt(softer);
  wall.normal_stiffness *= softer, wall.tangential_stiffness *= softer;
  wall.normal_damping *= root_softer, wall.tangential_damping *= root_softer;
  wall.effects.hertz_overlap /= softer;
  return wall;
}

}  // namespace regolab::dem
