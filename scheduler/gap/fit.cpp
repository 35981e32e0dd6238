#include "scheduler/gap/fit.h"

#include <algorithm>
#include <cmath>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::size_t cause_of(const Emulator& emulator, const std::string& effect) {
  const auto& causes = emulator.causes();
  return static_cast<std::size_t>(std::ranges::find_if(causes, [&](const Cause& c) { return c.effect->name == effect; }) - causes.begin());
}

/// In specimens of the size that was measured.
Level level_of(const Predicted& p, const Comparison& comparison, Index feature) {
  const VectorXd values = p.mean.row(feature);
  const double mean = values.mean(), spread = (values.array() - mean).square().mean();
  return {mean + comparison.size_shift[feature], std::sqrt(spread + p.variance.row(feature).mean())};
}

}  // namespace

const Weighed* repaired_by(const Diagnosis& d) {
  if (d.verdict != Verdict::kEffect && d.verdict != Verdict::kOneOf && d.verdict != Verdict::kPair) return nullptr;
  std::vector<std::string> wanted = d.classes;
  if (d.verdict == Verdict::kPair && wanted.size() == 2) wanted = {wanted[0] + "+" + wanted[1]};
  for (const Weighed& m : d.models) {  // most probable first
    if (!m.strength.empty() && std::ranges::find(wanted, m.cause) != wanted.end()) return &m;
  }
  return nullptr;
}

const Weighed* base_of(const Diagnosis& d) {
  const auto found = std::ranges::find(d.models, "none", &Weighed::model);
  return found == d.models.end() ? nullptr : &*found;
}

double read_by_gauge(const std::string& model, double strength, const FeatureInfo& feature) {
  return model.ends_with(kReadByAGauge) && feature.id.starts_with("sigma3_measured_ratio") ? strength / feature.group.sigma3 : 0;
}

Predicted emulated(const Emulator& emulator, const Weighed& model, const std::vector<Index>& features) {
  const auto n = static_cast<Index>(model.draws.size());
  MatrixXd values(static_cast<Index>(emulator.space().size()), n);
  std::vector<Use> uses;
  for (const Strength& s : model.strength) uses.push_back({cause_of(emulator, s.effect), VectorXd(n)});
  for (Index k = 0; k < n; ++k) {
    const Draw& draw = model.draws[static_cast<std::size_t>(k)];
    values.col(k) = Eigen::Map<const VectorXd>(draw.values.data(), values.rows());
    for (std::size_t c = 0; c < uses.size(); ++c) uses[c].strength[k] = draw.strength[c];
  }
  const Predicted all = emulator.predict(values, uses);
  Predicted out{all.mean(features, Eigen::all), all.variance(features, Eigen::all)};
  for (Index f = 0; f < out.mean.rows() && !uses.empty(); ++f) {
    const FeatureInfo& info = emulator.features()[static_cast<std::size_t>(features[static_cast<std::size_t>(f)])];
    for (Index k = 0; k < n; ++k) out.mean(f, k) += read_by_gauge(model.model, uses.front().strength[k], info);
  }
  return out;
}

std::vector<FeatureFit> fits_of(const Emulator& emulator, const Comparison& comparison, const Diagnosis& diagnosis) {
  std::vector<FeatureFit> out;
  const Weighed *base = base_of(diagnosis), *repaired = repaired_by(diagnosis);
  if (!base || base->draws.empty()) return out;
  const Predicted before = emulated(emulator, *base, comparison.feature);
  const std::optional<Predicted> after = repaired ? std::optional(emulated(emulator, *repaired, comparison.feature)) : std::nullopt;
  for (std::size_t f = 0; f < comparison.measured.size(); ++f) {
    const auto at = static_cast<Index>(f);
    out.push_back({.measured = comparison.measured[f], .base = level_of(before, comparison, at), .repaired = after ? std::optional(level_of(*after, comparison, at)) : std::nullopt});
  }
  return out;
}

}  // namespace regolab::gap
