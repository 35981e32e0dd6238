#include "scheduler/gap/noise_scale.h"

#include <cmath>
#include <vector>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRidge = 1;             // a slope that few materials speak for is small
constexpr double kLeastForetold = 0.15;  // share of the scatter of logarithms, materials left out one by one
constexpr double kMostScale = 6;

}  // namespace

NoiseScale::NoiseScale(const MatrixXd& x, const VectorXd& ratio) {
  std::vector<Index> rows;
  for (Index i = 0; i < ratio.size(); ++i) {
    if (std::isfinite(ratio[i]) && ratio[i] > 0) rows.push_back(i);
  }
  if (std::ssize(rows) < 2 * x.cols() + 10) return;
  const VectorXd y = ratio(rows).array().log();
  const MatrixXd a = x(rows, Eigen::all), centred = a.rowwise() - a.colwise().mean();
  const VectorXd off = y.array() - y.mean();
  const MatrixXd solve = (centred.transpose() * centred + kRidge * MatrixXd::Identity(x.cols(), x.cols())).ldlt().solve(centred.transpose());
  const VectorXd slope = solve * off, leverage = (centred.array() * solve.transpose().array()).rowwise().sum() + 1.0 / static_cast<double>(y.size());
  const VectorXd left_out = (off - centred * slope).array() / (1 - leverage.array());
  if (left_out.squaredNorm() > (1 - kLeastForetold) * off.squaredNorm()) return;
  slope_ = slope;
  level_ = -std::log((a * slope).array().exp().mean());
}

VectorXd NoiseScale::at(const MatrixXd& x) const {
  if (slope_.size() == 0) return VectorXd::Ones(x.rows());
  return (level_ + (x * slope_).array()).exp().cwiseMax(1 / kMostScale).cwiseMin(kMostScale);
}

}  // namespace regolab::gap
