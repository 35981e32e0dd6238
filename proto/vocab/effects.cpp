#include "vocab/effects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "vocab/exact_text.h"
#include "vocab/stage.h"

namespace regolab {
namespace {

/// A stage's own bit and that of the bed it starts from.
unsigned seen_by(StageKind kind) { return acts::kSettle | 1U << static_cast<unsigned>(kind); }

}  // namespace

const EffectInfo* find_effect(std::string_view name) {
  const auto found = std::ranges::find(all_effects(), name, &EffectInfo::name);
  return found == all_effects().end() ? nullptr : &*found;
}

EffectSet acting_in(const EffectSet& effects, StageKind kind) {
  EffectSet acting;
  for (const EffectInfo& info : all_effects()) {
    const bool meant = !info.variant_of || effects[*info.variant_of] != 0;
    if ((info.acts_in & seen_by(kind)) != 0 && meant && effects[info.id] != 0) acting[info.id] = effects[info.id];
  }
  return acting;
}

std::string effects_text(const EffectSet& effects) {
  std::map<std::string_view, double> on;
  for (const EffectInfo& info : all_effects()) {
    if (effects[info.id] != 0) on[info.name] = effects[info.id];
  }
  std::string text;
  for (const auto& [name, strength] : on) text += (text.empty() ? "" : ";") + std::string(name) + "=" + exact_text(strength);
  return text;
}

std::optional<EffectSet> effects_from_text(std::string_view text) {
  EffectSet effects;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(';'));
    text.remove_prefix(std::min(text.size(), item.size() + 1));
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const EffectInfo* info = find_effect(item.substr(0, equals));
    const auto strength = number_from_exact_text(item.substr(equals + 1));
    if (info == nullptr || !strength || !std::isfinite(*strength)) return std::nullopt;
    effects[info->id] = *strength;
  }
  return effects;
}

}  // namespace regolab
