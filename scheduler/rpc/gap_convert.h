/// Observations to their wire form; features also as physical quantities in door units.
#pragma once
#include "regolab/v1/lab.pb.h"
#include "scheduler/gap/diagnosis.h"
#include "scheduler/gap/features.h"
#include "scheduler/gap/fit.h"

namespace regolab {

v1::FeatureValue to_proto(const gap::Feature& feature);
v1::ImportReply to_proto(const gap::ObservationSet& set);
v1::Diagnosis to_proto(const gap::Diagnosis& diagnosis);
/// In door units.
v1::FittedFeature to_proto(const gap::FeatureFit& fit);
void add_where(const std::vector<gap::GroupGap>& where, v1::Diagnosis& out);

/// A file of measurements, or a CSV with its map.
Read<gap::ObservationSet> read_measurements_of(const v1::ImportRequest& request);

}  // namespace regolab
