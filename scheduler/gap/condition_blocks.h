/// The blocks `material`, `specimen` and `nominal_protocol`, which observation files and CSV maps share.
#pragma once
#include "input/map_reader.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

/// All three blocks may be absent. A key that nothing reads is listed in `set.unused`; a bad value goes to `report`.
void read_conditions(MapReader& top, ObservationSet& set, Report& report);

}  // namespace regolab::gap
