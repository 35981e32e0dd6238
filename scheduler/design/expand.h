/// From a design to the stages a worker runs, and to the empty table their numbers will fill.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scheduler/design/design.h"
#include "vocab/result_table.h"

namespace regolab {

/// The stages of one point and seed: settle first, then fabric, repose (if asked for), one stress stage per sigma3, one
/// penetration stage per plate.
/// All but the first start from the first one's bed (parent_of).
std::vector<StageSpec> expand(const Design& design, const DesignPoint& point, std::uint64_t seed);

/// Every stage of the study, by point, then seed.
std::vector<StageSpec> expand(const Design& design);

/// The responses the study will fill, primary ones first (is_primary), with SI units.
std::vector<TableResponse> responses_of(const Design& design);

/// The stage kind (and sigma3, for stress stages [Pa], or plate_text of the plate) that measures a response of responses_of.
struct ResponseSource {
  StageKind kind = StageKind::kFabric;
  double confining_stress = 0;
  std::string plate;
};
ResponseSource source_of(const std::string& response);

/// The study's table with factors, responses and one row per point and seed, no values yet and nothing called missing.
ResultTable empty_table(const Design& design, const std::string& experiment);

}  // namespace regolab
