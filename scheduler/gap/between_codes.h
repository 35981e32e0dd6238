/// What two codes of the same laws, or a code and a laboratory, differ by when nothing is wrong with either.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "scheduler/gap/features.h"

namespace regolab::gap {

/// Of each feature alone, in standard deviations of one run of ours.
inline constexpr double kAlone = 0.3;

/// Of features together, in the same unit: a column for each way in which they differ as one, of unit variance. [q][r]
Eigen::MatrixXd between_codes(const std::vector<Feature>& features);

}  // namespace regolab::gap
