/// What the instruments of a case make of its runs, where they err in ways that no effect of the library has.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "scheduler/gap/blind/truth.h"
#include "vocab/measurement.h"

namespace regolab::gap {

/// What was measured on one bed; a stage that ended without numbers is absent.
struct SpecimenRecord {
  std::optional<StageResult> fabric, repose;
  std::map<double, StageResult> stress;  ///< by sigma3 as said [Pa]
};

/// A stress test that ran under another sigma3 than it is said to have: ids and the lateral gauge say what was said.
StageResult relabelled(const StageResult& result, double applied, double said);

/// As the truth's departure has it recorded; a truth without one leaves the record alone.
void misrecord(const Truth& truth, SpecimenRecord& record);

}  // namespace regolab::gap
