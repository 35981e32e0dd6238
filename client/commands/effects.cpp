#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/json_view.h"
#include "client/table_print.h"
#include "vocab/stage.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

/// "settle, stress": the stages whose runs it changes; what acts in settling changes them all.
std::vector<std::string> stages_of(const EffectInfo& info) {
  std::vector<std::string> names;
  for (const StageKind kind : {StageKind::kSettle, StageKind::kFabric, StageKind::kRepose, StageKind::kStress, StageKind::kPenetration}) {
    if ((info.acts_in & 1U << static_cast<unsigned>(kind)) != 0) names.emplace_back(name_of(kind));
  }
  return names;
}

std::string range_of(const EffectInfo& info) {
  if (!info.choices.empty()) return fmt::format("{}", fmt::join(info.choices, " | "));
  const DoorUnit unit = door_unit(info.si);
  return fmt::format("{:g} to {:g}{}", info.prior_low * unit.factor, info.prior_high * unit.factor,
                     unit.name == "1" ? "" : " " + std::string(unit.name));
}

Json json_of(const EffectInfo& info) {
  Json effect{{"name", info.name},         {"version", info.version},         {"parameter", info.parameter},
              {"unit_si", info.si},        {"low", info.low},                 {"high", info.high},
              {"prior_low", info.prior_low}, {"prior_high", info.prior_high}, {"prior", info.logarithmic ? "log-uniform" : "uniform"},
              {"acts_in", stages_of(info)},  {"law", info.law},               {"moves", info.moves},
              {"source", info.source}};
  if (info.variant_of) effect["variant_of"] = info_of(*info.variant_of).name;
  if (!info.choices.empty()) effect["choices"] = info.choices;
  return effect;
}

}  // namespace

Outcome list_effects(const Arguments& arguments, Console& console) {
  if (arguments.json) {
    Json out = document("effects");
    out["effects"] = Json::array();
    for (const EffectInfo& info : all_effects()) out["effects"].push_back(json_of(info));
    console.out << text_of(out);
    return done();
  }
  Table table({{"name", {}, Align::kLeft}, {"parameter", {}, Align::kLeft}, {"prior range", {}, Align::kLeft}, {"acts in", {}, Align::kLeft}, {"v"}});
  for (const EffectInfo& info : all_effects()) {
    const bool everywhere = info.acts_in == acts::kEverywhere;
    table.add({std::string(info.name), std::string(info.parameter), range_of(info),
               everywhere ? "all" : fmt::format("{}", fmt::join(stages_of(info), ", ")), std::to_string(info.version)});
  }
  console.out << table.text() << "\n";
  for (const EffectInfo& info : all_effects()) {
    console.out << fmt::format("{}\n  law     {}\n  moves   {}\n  source  {}\n", info.name, info.law, info.moves, info.source);
  }
  return done();
}

}  // namespace regolab::client
