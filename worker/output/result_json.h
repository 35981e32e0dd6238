/// Everything a job gave, as one JSON document, `format: regolab.result/1`, and one stage of it as a record to keep.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/job_file.h"
#include "vocab/result.h"
#include "worker/output/finished_stage.h"

namespace regolab {

/// SI values in full (`value`, `unit`) beside door values (`shown`, `shown_unit`). A number that is not finite is null.
/// `end` is the first end other than "completed", else "completed".
std::string result_json(const Job& job, const std::vector<FinishedStage>& stages);

nlohmann::ordered_json stage_to_json(const FinishedStage& stage);

/// The end with this name (name_of's reverse).
std::optional<StageEnd> end_named(std::string_view name);

/// Reads back what stage_to_json wrote, bit for bit (null becomes NaN); the specification is the caller's.
/// Errors: kDataLoss when the document is not such a record.
Result<FinishedStage> stage_from_json(const nlohmann::ordered_json& json, const StageSpec& spec);

}  // namespace regolab
