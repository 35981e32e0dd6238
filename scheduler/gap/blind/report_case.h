/// What an experimenter hands in of a case: means over specimens with their errors, on one grid, in few digits, and nothing else.
#pragma once
#include <vector>

#include "scheduler/gap/blind/records.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

/// Every quantity that any specimen has; one that a single specimen has carries no error (a reader assumes one). Curves stand on the same
/// strains in every case, as far as the specimens reach. Material and protocol are what was meant.
ObservationSet observation_of(const Truth& truth, const std::vector<SpecimenRecord>& specimens);

}  // namespace regolab::gap
