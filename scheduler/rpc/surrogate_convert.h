/// Surrogates to their wire form, in door units.
#pragma once
#include "regolab/v1/lab.pb.h"
#include "scheduler/surrogate/model.h"

namespace regolab {

v1::ModelSummary to_proto(const surrogate::Model& model, std::int64_t created_unix_ms);
v1::Estimate to_proto(const surrogate::Estimate& estimate);

}  // namespace regolab
