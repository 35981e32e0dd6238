#include "worker/effects/contact.h"

#include <algorithm>

namespace regolab::effects {

dem::ContactEffects contact_effects(const EffectSet& effects, const HertzMatch& match) {
  dem::ContactEffects law;
  law.rolling = effects[EffectId::kRollingResistance];
  law.iwashita_oda = static_cast<RollingVariant>(static_cast<int>(effects[EffectId::kRollingVariant])) == RollingVariant::kIwashitaOda;
  law.cohesion = effects[EffectId::kCohesion];
  law.jkr = static_cast<CohesionVariant>(static_cast<int>(effects[EffectId::kCohesionVariant])) == CohesionVariant::kJkr;
  law.hertz = effects[EffectId::kHertzianContact];
  if (law.hertz > 0) {
    law.hertz_overlap = match.pressure * match.mean_diameter * match.mean_diameter / match.stiffness;
    law.hertz_most = match.largest_load;
  }
  return law;
}

double largest_stress_load(double sigma3) {
  constexpr double kChains = 10;
  return kChains * std::max(1.0, sigma3 / kStressMatch);
}

}  // namespace regolab::effects
