/// A job as it was resolved: every setting written out, in SI and in the units people read.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "input/job_file.h"

namespace regolab {

nlohmann::ordered_json job_json(const Job& job);

}  // namespace regolab
