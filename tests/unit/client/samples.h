/// Replies of a small made-up study, two factors and three responses on four points, point 4 without a repose angle.
#pragma once
#include "client/wire.h"

namespace regolab::client {

pb::ResultsReply sample_results();
pb::RangeReply sample_range();
pb::ExperimentStatus sample_status(const std::string& state = "running");
pb::DesignSummary sample_summary();
pb::TrainFunctionsReply sample_functions();  ///< BP-ANN-1 with one output; BP-ANN-2 without its factor

}  // namespace regolab::client
