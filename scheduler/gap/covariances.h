/// Covariances and correlations of features from rows that may lack some of them.
#pragma once
#include <Eigen/Dense>

namespace regolab::gap {

/// Mean product of each pair of columns over the rows that have both; 0 where none has. rows: [n][p] deviations, NaN where absent.
Eigen::MatrixXd paired_covariance(const Eigen::MatrixXd& rows);

/// The correlation, shrunk towards none by `shrinkage` and moved to the nearest matrix without negative eigenvalues. variance: [p] > 0.
Eigen::MatrixXd sound_correlation(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& variance, double shrinkage);

}  // namespace regolab::gap
