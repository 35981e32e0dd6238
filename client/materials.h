/// Materials from the command line and from CSV tables, as a surrogate is asked for them.
#pragma once
#include "client/arguments.h"
#include "client/outcome.h"
#include "client/wire.h"

namespace regolab::client {

/// --set and --table into `request`. A table's column is an input with its unit, as in a design's table ("K_N_N_per_m"); --set holds
/// for every row. kUsage or kInvalidInput with file and line.
Outcome read_materials(const Arguments& arguments, pb::PredictRequest& request);

/// --sigma3 "3 kPa" [Pa].
Outcome read_stresses(const Arguments& arguments, std::vector<double>& pascal);

}  // namespace regolab::client
