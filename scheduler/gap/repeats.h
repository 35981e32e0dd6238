/// Runs of the same material with different seeds: its mean, and what seeds do to all features together.
#pragma once
#include "scheduler/gap/space.h"

namespace regolab::gap {

struct Repeats {
  Eigen::MatrixXd values;       ///< [n_axes][n] micro-parameters [SI]
  Eigen::MatrixXd mean;         ///< [n][p] NaN where no seed has it
  Eigen::VectorXd weight;       ///< [n] seeds
  Eigen::VectorXd noise;        ///< [p] variance of one run, pooled
  Eigen::MatrixXd squares;      ///< [n][p] variance between the seeds of each material, NaN with fewer than two
  Eigen::MatrixXd correlation;  ///< [p][p] of the deviations, shrunk towards none
};

Repeats repeats_without_effects(const Bank& bank, const Space& space);

}  // namespace regolab::gap
