#include "input/effect_field.h"

#include <array>
#include <utility>
#include <vector>

namespace regolab {
namespace {

template <std::size_t id>
void set_effect(Settings& settings, double strength) {
  settings.effects.strength[id] = strength;
}

template <std::size_t... ids>
constexpr std::array<void (*)(Settings&, double), kEffectCount> setters(std::index_sequence<ids...>) {
  return {set_effect<ids>...};
}
constexpr auto kSetters = setters(std::make_index_sequence<kEffectCount>{});

/// Kept for the life of the program: fields hold spans and views of it.
struct Texts {
  std::vector<Choice> choices;
  std::string usual;
};

Texts texts_of(const EffectInfo& info) {
  Texts texts{{}, "0 leaves it out; " + std::string(info.law)};
  for (std::size_t i = 0; i < info.choices.size(); ++i) texts.choices.push_back({info.choices[i], info.choices[i], static_cast<int>(i)});
  return texts;
}

}  // namespace

std::span<const Field> effect_fields() {
  static const auto texts = [] {
    std::array<Texts, kEffectCount> all;
    for (const EffectInfo& info : all_effects()) all[static_cast<std::size_t>(info.id)] = texts_of(info);
    return all;
  }();
  static const auto fields = [] {
    std::array<Field, kEffectCount> all;
    for (const EffectInfo& info : all_effects()) {
      const auto id = static_cast<std::size_t>(info.id);
      all[id] = {.group = Field::Group::kEffect,
                 .name = info.name,
                 .si = info.si,
                 .what = info.choices.empty() ? "strength of an effect" : "law of an effect",
                 .low = info.low,
                 .high = info.high,
                 .usual = texts[id].usual,
                 .choices = texts[id].choices,
                 .set = kSetters[id]};
    }
    return all;
  }();
  return fields;
}

}  // namespace regolab
