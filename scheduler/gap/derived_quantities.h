/// Quantities that follow from others: each measurement counts once.
#pragma once
#include "scheduler/gap/observation_merge.h"

namespace regolab::gap {

/// Density and void ratio are one measurement: with the grain density known, the density stays. Cohesion and friction angle follow from
/// sigma1: they are used only where it is not given, and only together. What is left out is listed in `set.unused`.
void resolve_derived(ObservationSet& set, const Merger& merger, Report& warnings);

}  // namespace regolab::gap
