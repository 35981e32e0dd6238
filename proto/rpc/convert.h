/// Vocabulary to wire and back. from_proto() checks what a stranger may have sent: enums out of range, numbers that are
/// none.
#pragma once
#include "regolab/v1/model.pb.h"
#include "vocab/measurement.h"
#include "vocab/result.h"
#include "vocab/stage.h"

namespace regolab {

v1::StageSpec to_proto(const StageSpec& spec);
v1::StageResult to_proto(const StageResult& result);

Result<StageSpec> from_proto(const v1::StageSpec& spec);
Result<StageResult> from_proto(const v1::StageResult& result);

}  // namespace regolab
