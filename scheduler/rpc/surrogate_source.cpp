#include "scheduler/rpc/surrogate_source.h"

#include <algorithm>

#include "scheduler/rpc/profile_name.h"
#include "scheduler/rpc/result_table.h"

namespace regolab {
namespace {

bool varies(const ResultTable& table, std::string_view name) {
  return std::ranges::find(table.factors, name, &TableFactor::name) != table.factors.end();
}

}  // namespace

Result<surrogate::Source> surrogate_source(Reader& reader, const std::string& label) {
  auto table = result_table(reader, label);
  if (!table.ok()) return table.error();
  surrogate::Source source{.table = std::move(table->table), .curves = {}};
  const auto design = reader.design(label);
  if (!design.ok()) return design.error();
  const auto stages = reader.stages(design->id);
  if (!stages.ok()) return stages.error();
  for (const StoredStage& stage : *stages) {
    const StageSpec& spec = stage.record.identity.spec;
    if (!varies(source.table, "particles")) source.table.fixed.try_emplace("particles", std::to_string(spec.numerics.clusters));
    if (const std::string name = profile_name(spec.numerics); !name.empty()) source.table.fixed.try_emplace("profile", name);
    if (spec.kind != StageKind::kStress || stage.record.status.end != StageEnd::kCompleted) continue;
    const auto result = reader.result(stage.link.job);
    if (!result.ok()) return result.error();
    for (const Curve& curve : result->curves) {
      constexpr std::string_view kPrefix = "sigma1_at_";
      if (!curve.id.starts_with(kPrefix)) continue;
      auto samples = surrogate::sampled(curve.x, curve.y);
      if (samples.empty()) continue;
      source.curves[{stage.link.point, stage.link.seed}]["sigma1_curve_at_" + curve.id.substr(kPrefix.size())] = std::move(samples);
    }
  }
  return source;
}

}  // namespace regolab
