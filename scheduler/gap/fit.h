/// The re-calibrated base model and the repaired one beside what was measured, by the emulator, at draws of their posteriors.
#pragma once
#include <vector>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {

/// The effect (or effects) that a diagnosis would add: the most probable model with any, among the classes that its verdict names. Null
/// when there is none: no gap, none of these, cannot tell, or one of the base model and the unknown.
const Weighed* repaired_by(const Diagnosis& diagnosis);
/// The base model, re-calibrated. Null in a diagnosis that was never weighed.
const Weighed* base_of(const Diagnosis& diagnosis);

/// What a gauge beside the controller adds to a feature, where the model says that it shows the lateral stress offset.
double read_by_gauge(const std::string& model, double strength, const FeatureInfo& feature);

/// The emulator's means of some features at a model's draws, and the variance it gives them. [q][n_draws]
Predicted emulated(const Emulator& emulator, const Weighed& model, const std::vector<Eigen::Index>& features);

struct Level {
  double value = 0, standard_error = 0;  ///< spread of the draws, and the emulator's error
};
struct FeatureFit {
  Feature measured;
  Level base;
  std::optional<Level> repaired;
};
/// Every feature that was compared.
std::vector<FeatureFit> fits_of(const Emulator& emulator, const Comparison& comparison, const Diagnosis& diagnosis);

}  // namespace regolab::gap
