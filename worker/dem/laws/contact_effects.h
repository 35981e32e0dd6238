/// What a contact law has beyond springs, dashpots and Coulomb's cap; all 0: nothing. worker/effects sets it.
#pragma once

namespace regolab::dem {

/// Share of the contact's diameter over which attraction reaches beyond touch.
inline constexpr double kAttractionRange = 0.02;

struct ContactEffects {
  double rolling = 0;           ///< mu_r
  double cohesion = 0;          ///< c* = F_c/d^2, between grains [Pa]
  double hertz = 0;             ///< h: share of the root law
  double hertz_overlap = 0;     ///< u_0, where the root law's K is the linear one's [m]
  double hertz_most = 1;        ///< largest overlap over u_0 that the step reckons with
  double wall_compliance = 0;   ///< c: walls have K/(1 + c)
  bool iwashita_oda = false;    ///< the rolling spring's variant
  bool jkr = false;             ///< the attraction's variant

  bool any() const { return rolling > 0 || cohesion > 0 || hertz > 0 || wall_compliance > 0; }

  template <class A>
  void archive(A& ar) { ar(rolling, cohesion, hertz, hertz_overlap, hertz_most, wall_compliance, iwashita_oda, jkr); }
};

}  // namespace regolab::dem
