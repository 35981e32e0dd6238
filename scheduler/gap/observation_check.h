/// From numbers as written to an ObservationSet: units, ranges, errors, repeats, and quantities that say the same thing twice.
#pragma once
#include "scheduler/gap/observation_file.h"
#include "scheduler/gap/raw_observation.h"

namespace regolab::gap {

/// Fills scalars, curves, unused and the marks of `set`, whose material is read already. What is refused goes to `report`, what is
/// odd to `warnings`.
void check_observations(const RawObservations& raw, MissingErrors missing, ObservationSet& set, Report& report, Report& warnings);

}  // namespace regolab::gap
