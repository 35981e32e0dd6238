/// What the strengths mean to the protocols, where a number says it all. Each is neutral, to the bit, at strength 0.
#pragma once
#include <algorithm>
#include <cmath>

#include "vocab/effects.h"

namespace regolab::effects {

inline double power_of_ten(double exponent) { return exponent == 0 ? 1.0 : std::pow(10.0, exponent); }

/// Of axial strain rate and plate speed.
inline double rate_factor(const EffectSet& e) { return power_of_ten(e[EffectId::kLoadingRate]); }
/// Gravity while the bed falls over its own.
inline double settling_gravity_ratio(const EffectSet& e) { return power_of_ten(e[EffectId::kPreparationGravity]); }
/// Friction of grains, with one another and with the floor, while the bed falls over their own.
inline double settling_friction_share(const EffectSet& e) { return 1 - e[EffectId::kPreparationFriction]; }
/// True grain density over the one stated.
inline double density_ratio(const EffectSet& e) { return 1 + e[EffectId::kGrainDensity]; }
/// Of side walls and stress platens; the penetration plate stays at least as rough as the grains.
inline double wall_friction(const EffectSet& e) { return e[EffectId::kWallFriction]; }
inline double plate_friction(const EffectSet& e, double grains) { return std::max(grains, wall_friction(e)); }
/// What softened springs are reckoned from beside the pressure: attraction presses grains together, too. At a stiffness number of 300 it
/// then takes less than 2 % of a sphere's diameter [Pa].
inline double attraction_pressure(const EffectSet& e) { return 0.1 * e[EffectId::kCohesion]; }
/// Steps in which the servo answers: a faster test has fewer.
inline double servo_steps(const EffectSet& e, double usual) { return std::max(5.0, usual / std::max(1.0, rate_factor(e))); }
/// Strength of the bonds in a cluster [Pa].
inline double bond_strength(const EffectSet& e) { return 1e5 / e[EffectId::kBreakage]; }

}  // namespace regolab::effects
