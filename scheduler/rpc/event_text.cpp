#include <fmt/format.h>

#include "scheduler/rpc/persist.h"
#include "vocab/units.h"

namespace regolab {
namespace {

/// The number a reader of the log wants to see of a stage.
std::string headline(const StageSpec& spec, const StageResult& result) {
  const std::string_view wanted = spec.kind == StageKind::kFabric   ? "bulk_density"
                                  : spec.kind == StageKind::kRepose ? "repose_angle"
                                  : spec.kind == StageKind::kPenetration ? "penetration_force_0.25_0.50_plate_"
                                                                         : "sigma1_at_sigma3_";
  for (const Measurement& m : result.measurements) {
    if (!m.id.starts_with(wanted) || spec.kind == StageKind::kSettle) continue;
    const DoorUnit door = door_unit(m.unit);
    return fmt::format("{:.4g} {}", m.value * door.factor, door.name);
  }
  return "done";
}

}  // namespace

std::string stage_text(const StageSpec& spec) {
  if (spec.kind == StageKind::kPenetration) return "penetration " + plate_text(spec.plate);
  if (spec.kind != StageKind::kStress) return std::string(name_of(spec.kind));
  return fmt::format("stress {:.4g} kPa", spec.confining_stress * 1e-3);
}

std::string event_text(const EventNoted& event, const JobQueue& queue) {
  switch (event.kind) {
    case EventKind::kSubmitted: return "submitted";
    case EventKind::kEnded: return std::string(name_of(queue.find(event.experiment)->state));
    default: break;
  }
  const StageSpec& spec = queue.find(event.job)->identity.spec;
  const std::string where = fmt::format("point {} seed {} {}: ", event.point, event.seed, stage_text(spec));
  if (event.kind == EventKind::kRetry) return where + "will be tried again (" + event.detail + ")";
  if (event.state == JobState::kSucceeded && event.result) {
    if (event.result->end == StageEnd::kCompleted) return where + headline(spec, *event.result);
    return where + fmt::format("{} ({})", name_of(event.result->end), event.result->reason);
  }
  return where + std::string(name_of(event.state)) + (event.detail.empty() ? "" : " (" + event.detail + ")");
}

}  // namespace regolab
