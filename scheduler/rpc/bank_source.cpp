#include "scheduler/rpc/bank_source.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "input/field_value.h"
#include "input/number_text.h"
#include "input/unit_convert.h"
#include "scheduler/rpc/bank_variants.h"
#include "scheduler/rpc/profile_name.h"

namespace regolab {
namespace {

struct MicroColumn {
  const char* name;
  const char* unit;
  double (*get)(const StageSpec&);
};

constexpr MicroColumn kMicro[] = {
    {"theta_F", "rad", [](const StageSpec& s) { return s.micro.friction_angle; }},
    {"K_N", "N/m", [](const StageSpec& s) { return s.micro.normal_stiffness; }},
    {"eta_N", "N s/m", [](const StageSpec& s) { return s.micro.normal_damping; }},
    {"K_T", "N/m", [](const StageSpec& s) { return s.micro.tangential_stiffness; }},
    {"eta_T", "N s/m", [](const StageSpec& s) { return s.micro.tangential_damping; }},
    {"L_S", "m", [](const StageSpec& s) { return s.micro.largest_diameter; }},
    {"N_E", "1", [](const StageSpec& s) { return static_cast<double>(s.micro.kind); }},
    {"rotation", "1", [](const StageSpec& s) { return static_cast<double>(s.micro.rotation); }},
    {"gravity", "m/s2", [](const StageSpec& s) { return s.micro.gravity; }},
    {"particle_density", "kg/m3", [](const StageSpec& s) { return s.micro.grain_density; }},
    {"particles", "1", [](const StageSpec& s) { return static_cast<double>(s.numerics.clusters); }},
};

bool is_micro(const std::string& name) {
  return name == "damping_unit" || std::ranges::any_of(kMicro, [&](const MicroColumn& column) { return name == column.name; });
}

/// A level of a factor, in SI. A factor that this program does not know as a field keeps the dimension its label has.
Result<std::pair<gap::BankInput, double>> level_of(const TableFactor& factor, const std::string& label) {
  Report report("", "");
  if (const Field* field = find_field(factor.name)) {
    const auto value = read_field(*field, label, factor.unit == "1" ? "" : factor.unit, factor.name, {}, report);
    if (!value) return invalid(report.take().front().text);
    return std::pair{gap::BankInput{factor.name, std::string(field->si)}, *value};
  }
  const auto number = leading_number(label);
  if (!number) return invalid("factor " + factor.name + ": level '" + excerpt(label) + "' is not a number (a bank has numbers only) leave that experiment out");
  const std::string unit = number->rest.empty() ? factor.unit : std::string(number->rest);
  if (unit.empty() || unit == "1") return std::pair{gap::BankInput{factor.name, "1"}, number->value};
  for (const char* si : {"Pa", "rad", "N/m", "N s/m", "kg/m3", "m/s2", "J/m2", "N/m3", "m/s", "1/s", "N", "J", "m", "kg", "s", "1"}) {
    if (const auto value = convert_to_si(number->value, label, unit, si, factor.name); value.ok()) return std::pair{gap::BankInput{factor.name, si}, *value};
  }
  return invalid("factor " + factor.name + ": unit '" + excerpt(unit) + "' is not known (the bank is in SI) leave that experiment out");
}

void add_micro(const StageSpec& spec, gap::BankSource& source) {
  for (const MicroColumn& column : kMicro) source.inputs.emplace_back(gap::BankInput{column.name, column.unit}, column.get(spec));
  if (spec.micro.damping_unit == DampingUnit::kRatio) source.inputs.emplace_back(gap::BankInput{"damping_is_ratio", "1"}, 1);  // eta is a ratio in this row
}

Result<void> add_factors(const ExperimentRecord& design, gap::BankSource& source) {
  const auto row = static_cast<std::size_t>(source.point - 1);
  for (std::size_t f = 0; f < design.factors.size() && row < design.levels.size(); ++f) {
    if (is_micro(design.factors[f].name)) continue;
    const auto value = level_of(design.factors[f], design.factors[f].levels[static_cast<std::size_t>(design.levels[row][f])]);
    if (!value.ok()) return value.error();
    source.inputs.push_back(*value);
  }
  return {};
}

/// Effects that a study keeps fixed. A stage knows those that act in it.
void add_effects(const EffectSet& effects, gap::BankSource& source) {
  for (const EffectInfo& effect : all_effects()) {
    const std::string name(effect.name);
    if (effects[effect.id] == 0 || std::ranges::any_of(source.inputs, [&](const auto& known) { return known.first.name == name; })) continue;
    source.inputs.emplace_back(gap::BankInput{name, std::string(effect.si)}, effects[effect.id]);
  }
}

}  // namespace

Result<std::vector<gap::BankSource>> bank_sources(Reader& reader, const std::string& label) {
  const auto design = reader.design(label);
  if (!design.ok()) return design.error();
  const auto stages = reader.stages(design->id);
  if (!stages.ok()) return stages.error();
  std::map<std::pair<int, std::uint64_t>, gap::BankSource> sources;
  std::map<std::pair<int, std::uint64_t>, std::vector<FinishedStress>> stress;
  for (const StoredStage& stage : *stages) {
    const auto [at, fresh] = sources.try_emplace({stage.link.point, stage.link.seed});
    gap::BankSource& source = at->second;
    if (fresh) {
      source.experiment = label, source.point = stage.link.point, source.seed = stage.link.seed;
      source.profile = profile_name(stage.record.identity.spec.numerics);
      add_micro(stage.record.identity.spec, source);
      if (auto added = add_factors(*design, source); !added.ok()) return added.error();
    }
    add_effects(stage.record.identity.spec.effects, source);
    const bool measures = stage.record.identity.spec.kind != StageKind::kSettle;  // settling leaves long curves of its own course
    if (!measures || stage.record.status.end != StageEnd::kCompleted) continue;
    const auto result = reader.result(stage.link.job);
    if (!result.ok()) return result.error();
    gap::add_readings(*result, source.readings);
    if (stage.record.identity.spec.kind == StageKind::kStress) stress[at->first].push_back({stage.record.identity.spec, *result});
  }
  std::vector<gap::BankSource> out;
  int point = 0;
  for (auto& [cell, source] : sources) {
    const bool first = cell.first != point;  // variants of a point's first seed
    point = cell.first;
    if (first) {
      std::ranges::move(bank_variants(source, stress[cell]), std::back_inserter(out));
    }
    out.push_back(std::move(source));
  }
  return out;
}

}  // namespace regolab
