/// Observations to their wire form; features also as physical quantities in door units.
#pragma once
#include "regolab/v1/lab.pb.h"
#include "scheduler/gap/features.h"

namespace regolab {

v1::FeatureValue to_proto(const gap::Feature& feature);
v1::ImportReply to_proto(const gap::ObservationSet& set);

}  // namespace regolab
