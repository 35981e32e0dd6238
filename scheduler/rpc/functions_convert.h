/// The trained prediction functions to their wire form: field by field, nothing decided here.
#pragma once
#include "regolab/v1/lab.pb.h"
#include "scheduler/surrogate/bp_ann_report.h"

namespace regolab {

v1::TrainFunctionsReply to_proto(const surrogate::FunctionsReport& report);

}  // namespace regolab
