/// What the job measured, as a laboratory would hand it over: `format: observations/1`.
#pragma once
#include <string>
#include <vector>

#include "input/job_file.h"
#include "worker/output/finished_stage.h"

namespace regolab {

/// Door units (kPa, g/cm3, deg, cm). One seed, so `seeds: 1`, and `standard_error` is null unless the protocol itself gives
/// one. Values that are not finite, and the measurements of stages that did not complete, are left out. The micro-parameters
/// are not in it: a diagnosis has to do without them.
std::string observations_yaml(const Job& job, const std::vector<FinishedStage>& stages, const std::string& case_name);

}  // namespace regolab
