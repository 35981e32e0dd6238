#include "scheduler/rpc/result_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scheduler/design/expand.h"

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
         (spec.kind != StageKind::kStress || std::abs(spec.confining_stress - source.confining_stress) < 1);
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
