/// What two codes of the same laws, or a code and a laboratory, differ by when nothing is wrong with either.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "scheduler/gap/features.h"

namespace regolab::gap {

/// Of each feature alone, in standard deviations of one run of ours.
inline constexpr double kAlone = 0.3;

/// What the length of the time step does within one code, in the same unit: servos answer by the step, and records are taken by it. A third
/// of the step more or less; read off 58 specimens without effects whose steps were 0.08 to 0.18 beside our emulators'. [q]
Eigen::VectorXd by_step(const std::vector<Feature>& features);
/// And of each feature alone: a peak is as high as records are dense. [q]
Eigen::VectorXd by_records(const std::vector<Feature>& features);

/// Of features together, in the same unit: a column for each way in which they differ as one, of unit variance. [q][r]
Eigen::MatrixXd between_codes(const std::vector<Feature>& features);

}  // namespace regolab::gap
