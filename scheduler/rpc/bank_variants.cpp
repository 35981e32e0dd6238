#include "scheduler/rpc/bank_variants.h"

#include <cmath>

#include "apparatus/apparatus.h"

namespace regolab {
namespace {

constexpr EffectId kWithoutDem[] = {EffectId::kFrameCompliance, EffectId::kSeating, EffectId::kLoadCellOffset, EffectId::kLoadCellGain, EffectId::kGrainDensity};
constexpr int kEvery = 3;  // of the points, for each effect

double golden(int k) {
  const double share = 0.3 + 0.6180339887498949 * k;  // the middle of a symmetric prior is no effect
  return share - std::floor(share);
}

double strength_at(const EffectInfo& effect, double share) {
  return effect.logarithmic ? effect.prior_low * std::pow(effect.prior_high / effect.prior_low, share)
                            : effect.prior_low + (effect.prior_high - effect.prior_low) * share;
}

/// True mass, stated density: what is weighed is (1 + x) times heavier than its solid volume says.
void weigh(double x, gap::Readings& readings) {
  for (auto& [id, reading] : readings.scalars) {
    if (id == "bulk_density" || id == "bulk_density_Hmax" || id == "core_density") reading.value *= 1 + x;
    if (id == "void_ratio" || id.starts_with("void_ratio_compressed")) reading.value = (1 + reading.value) / (1 + x) - 1;
  }
}

}  // namespace

std::vector<gap::BankSource> bank_variants(const gap::BankSource& base, const std::vector<FinishedStress>& stress) {
  std::vector<gap::BankSource> out;
  for (const auto& [input, value] : base.inputs) {
    if (value != 0 && find_effect(input.name)) return out;
  }
  for (std::size_t k = 0; k < std::size(kWithoutDem) && !stress.empty(); ++k) {
    if (base.point % kEvery != static_cast<int>(k) % kEvery) continue;
    const EffectInfo& effect = info_of(kWithoutDem[k]);
    const double strength = strength_at(effect, golden(base.point / kEvery));
    gap::BankSource source = base;
    source.experiment += "+" + std::string(effect.name);
    source.inputs.emplace_back(gap::BankInput{std::string(effect.name), std::string(effect.si)}, strength);
    EffectSet effects;
    effects[effect.id] = strength;
    bool whole = true;
    for (const FinishedStress& one : stress) {
      if (effect.id == EffectId::kGrainDensity) break;
      const auto seen = as_measured(one.result, one.spec.confining_stress, one.spec.numerics.axial_strain, apparatus_of(effects));
      whole = whole && seen.ok();  // a stage without curves cannot be seen through another apparatus
      if (whole) gap::add_readings(*seen, source.readings);
    }
    if (effect.id == EffectId::kGrainDensity) weigh(strength, source.readings);
    if (whole) out.push_back(std::move(source));
  }
  return out;
}

}  // namespace regolab
