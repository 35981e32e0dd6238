/// What both readers of observations do last.
#pragma once
#include "input/report.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

/// Refuses a set of which nothing can be used, marks one with few features, hands over the warnings. A set with problems is none.
Read<ObservationSet> finished(std::optional<ObservationSet> set, Report& report, Report& warnings);

}  // namespace regolab::gap
