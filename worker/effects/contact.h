/// From strengths to what the contact law has beyond the base model: rolling resistance, cohesion, Hertz's root.
#pragma once
#include "vocab/effects.h"
#include "worker/dem/laws/contact_effects.h"

namespace regolab::effects {

/// Where Hertz's spring is matched to the linear one: a contact of mean diameter d under the pressure p carries p d^2.
struct HertzMatch {
  double pressure = 0;       ///< [Pa]
  double mean_diameter = 0;  ///< [m]
  double stiffness = 0;      ///< K_N as the stage uses it [N/m]
  double largest_load = 1;   ///< overlap over the matched one that the step reckons with
};

dem::ContactEffects contact_effects(const EffectSet& effects, const HertzMatch& match);

/// Of the stress tests: the article's pressures lie on both sides of it [Pa].
inline constexpr double kStressMatch = 5000;

/// Overlaps over the matched one in settling: falling grains press far beyond their weight (measured: 25 times).
inline constexpr double kLargestSettlingLoad = 25;
/// In a stress test at sigma3: force chains carry a few times the mean force.
double largest_stress_load(double sigma3);

}  // namespace regolab::effects
