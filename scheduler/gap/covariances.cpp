#include "scheduler/gap/covariances.h"

#include <Eigen/Eigenvalues>

namespace regolab::gap {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd paired_covariance(const MatrixXd& rows) {
  const MatrixXd present = rows.array().isFinite().cast<double>(), filled = rows.array().isFinite().select(rows, 0.0);
  const MatrixXd pairs = present.transpose() * present;
  return (filled.transpose() * filled).array() / pairs.array().max(1.0);
}

MatrixXd sound_correlation(const MatrixXd& covariance, const VectorXd& variance, double shrinkage) {
  const VectorXd root = variance.cwiseSqrt().cwiseInverse();
  MatrixXd c = (1 - shrinkage) * (root.asDiagonal() * covariance * root.asDiagonal());
  c.diagonal().setOnes();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(c);
  const MatrixXd up = solved.eigenvectors() * solved.eigenvalues().cwiseMax(1e-3).asDiagonal() * solved.eigenvectors().transpose();
  const VectorXd scale = up.diagonal().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * up * scale.asDiagonal();
}

}  // namespace regolab::gap
