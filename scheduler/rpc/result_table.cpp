#include "scheduler/rpc/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "scheduler/design/expand.h"
#include "vocab/units.h"

namespace regolab {
namespace {

using Cell = std::pair<int, std::uint64_t>;  // point, seed

std::string in_words(std::string end_name) {
  std::replace(end_name.begin(), end_name.end(), '_', ' ');
  return end_name;
}

/// Why a stage has no numbers; empty when it has.
std::string reason_of(const StoredStage& stage) {
  const JobStatus& status = stage.record.status;
  switch (status.state) {
    case JobState::kSucceeded:
      if (status.end == StageEnd::kCompleted) return "";
      return in_words(stage.end_name.value_or("ended")) + " (" + status.detail + ")";
    case JobState::kFailed: return "failed: " + status.detail;
    case JobState::kQuarantined: return "quarantined: " + status.detail;
    case JobState::kSkipped: return status.detail;
    case JobState::kCancelled: return "cancelled";
    default: return "pending";
  }
}

bool measures(const StageSpec& spec, const ResponseSource& source) {
  return spec.kind == source.kind &&
         (spec.kind != StageKind::kStress || std::abs(spec.confining_stress - source.confining_stress) < 1) &&
         (spec.kind != StageKind::kPenetration || plate_text(spec.plate) == source.plate);
}

std::string missing_why(const std::vector<const StoredStage*>& stages, const std::string& response) {
  const ResponseSource source = source_of(response);
  for (const StoredStage* stage : stages) {
    if (!measures(stage->record.identity.spec, source)) continue;
    const std::string reason = reason_of(*stage);
    return reason.empty() ? "not measured (its stage completed without this number)" : reason;
  }
  return "not asked for";
}

/// Every parameter of a material by the name designs give it, in the article's units ("1.63 m/s2").
std::map<std::string, std::string> parameters_of(const Micro& m) {
  constexpr std::array<std::string_view, 4> kRotations = {"none", "x", "z", "xz"};
  const bool ratio = m.damping_unit == DampingUnit::kRatio;
  const auto eta = [&](double value) { return fmt::format("{:.10g}{}", value, ratio ? "" : " N s/m"); };
  return {{"theta_F", fmt::format("{:.10g} deg", m.friction_angle / kDegree)},
          {"K_N", fmt::format("{:.10g} N/m", m.normal_stiffness)},
          {"eta_N", eta(m.normal_damping)},
          {"K_T", fmt::format("{:.10g} N/m", m.tangential_stiffness)},
          {"eta_T", eta(m.tangential_damping)},
          {"L_S", fmt::format("{:.10g} cm", m.largest_diameter * door_unit("m").factor)},
          {"N_E", m.kind == ParticleKind::kMixture ? "mixture" : std::to_string(static_cast<int>(m.kind))},
          {"rotation", std::string(kRotations[static_cast<std::size_t>(m.rotation)])},
          {"damping_unit", ratio ? "ratio" : "absolute"},
          {"particle_density", fmt::format("{:.10g} g/cm3", m.grain_density * door_unit("kg/m3").factor)},
          {"gravity", fmt::format("{:.10g} m/s2", m.gravity)}};
}

}  // namespace

Result<NamedTable> result_table(Reader& reader, const std::string& label) {
  auto design = reader.design(label);
  if (!design.ok()) return design.error();
  const auto stages = reader.stages(design->id);
  if (!stages.ok()) return stages.error();
  const auto responses = reader.responses(design->id);
  if (!responses.ok()) return responses.error();

  NamedTable out{{.experiment = label, .array = design->array, .factors = design->factors, .responses = {}, .rows = {}},
                 design->name};
  for (const ResponseRecord& r : design->responses) out.table.responses.push_back({r.id, r.unit});
  if (!stages->empty()) {  // what is no factor is the same in every stage
    out.table.fixed = parameters_of(stages->front().record.identity.spec.micro);
    for (const TableFactor& factor : out.table.factors) out.table.fixed.erase(factor.name);
  }
  std::map<Cell, std::vector<const StoredStage*>> by_cell;
  for (const StoredStage& stage : *stages) by_cell[{stage.link.point, stage.link.seed}].push_back(&stage);
  std::map<Cell, std::map<std::string, double>> values;
  for (const StoredResponse& r : *responses) values[{r.point, r.seed}][r.id] = r.value;

  for (const auto& [cell, own_stages] : by_cell) {
    TableRow row{.point = cell.first, .seed = cell.second, .level = {}, .value = {}, .missing = {}};
    const auto index = static_cast<std::size_t>(cell.first - 1);
    if (index < design->levels.size()) row.level = design->levels[index];
    const auto& measured = values[cell];
    for (const ResponseRecord& response : design->responses) {
      if (const auto found = measured.find(response.id); found != measured.end())
        row.value[response.id] = found->second;
      else
        row.missing[response.id] = missing_why(own_stages, response.id);
    }
    out.table.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace regolab
