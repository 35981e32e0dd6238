#include "vocab/measurement.h"

namespace regolab {

std::string_view name_of(StageEnd end) {
  switch (end) {
    case StageEnd::kCompleted: return "completed";
    case StageEnd::kNotSettled: return "not_settled";
    case StageEnd::kEnergyGrowth: return "energy_growth";
    case StageEnd::kOverlap: return "overlap";
    case StageEnd::kUnstable: return "unstable";
    case StageEnd::kLostCluster: return "lost_cluster";
    case StageEnd::kNoRoom: return "no_room";
    case StageEnd::kCancelled: return "cancelled";
  }
  return "unknown";
}

}  // namespace regolab
