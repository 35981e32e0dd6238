#include "scheduler/gap/repeats.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>

#include "vocab/effects.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShrinkage = 0.1;     // of correlations: as many features as a third of the degrees of freedom
constexpr double kLeastNoise = 1e-12;  // a feature that seeds never change (a share that is always 0)
constexpr double kOfStood = 0.04;      // variance of a share of slopes that stood: none of two need not mean never

bool has_effect(const Bank& bank, const BankRow& row) {
  for (std::size_t i = 0; i < bank.inputs.size(); ++i) {
    if (row.inputs[i] != 0 && find_effect(bank.inputs[i].name)) return true;
  }
  return false;
}

VectorXd features_of_row(const BankRow& row) { return Eigen::Map<const VectorXd>(row.features.data(), static_cast<Index>(row.features.size())); }

/// Mean of each feature over the runs that have it.
VectorXd mean_of(const std::vector<VectorXd>& runs) {
  VectorXd sum = VectorXd::Zero(runs.front().size()), count = sum;
  for (const VectorXd& run : runs) {
    for (Index j = 0; j < run.size(); ++j) {
      if (std::isfinite(run[j])) sum[j] += run[j], ++count[j];
    }
  }
  return sum.array() / count.array();  // NaN where none has it
}

/// The nearest matrix without negative eigenvalues, its diagonal 1.
MatrixXd made_sound(const MatrixXd& c) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(c);
  const MatrixXd up = solved.eigenvectors() * solved.eigenvalues().cwiseMax(1e-3).asDiagonal() * solved.eigenvectors().transpose();
  const VectorXd root = up.diagonal().cwiseSqrt().cwiseInverse();
  return root.asDiagonal() * up * root.asDiagonal();
}

}  // namespace

Repeats repeats_without_effects(const Bank& bank, const Space& space) {
  std::map<std::vector<double>, std::vector<VectorXd>> by_material;
  for (const BankRow& row : bank.rows) {
    if (!has_effect(bank, row)) by_material[row.inputs].push_back(features_of_row(row));
  }
  const auto n = static_cast<Index>(by_material.size()), p = static_cast<Index>(bank.features.size());
  Repeats out{MatrixXd(static_cast<Index>(space.size()), n), MatrixXd(n, p), VectorXd(n), VectorXd::Zero(p), MatrixXd::Zero(p, p)};
  MatrixXd products = MatrixXd::Zero(p, p), pairs = products;
  Index i = 0;
  for (const auto& [inputs, runs] : by_material) {
    for (std::size_t k = 0; k < space.size(); ++k) out.values(static_cast<Index>(k), i) = inputs[*bank.input(space.axes[k].name)];
    const VectorXd mean = mean_of(runs);
    out.mean.row(i) = mean.transpose();
    out.weight[i++] = static_cast<double>(runs.size());
    if (runs.size() < 2) continue;
    const double unbiased = static_cast<double>(runs.size()) / static_cast<double>(runs.size() - 1);
    for (const VectorXd& run : runs) {
      for (Index a = 0; a < p; ++a) {
        for (Index b = 0; b < p; ++b) {
          const double product = (run[a] - mean[a]) * (run[b] - mean[b]) * unbiased;
          if (std::isfinite(product)) products(a, b) += product, ++pairs(a, b);
        }
      }
    }
  }
  const MatrixXd covariance = (pairs.array() > 0).select(products.array() / pairs.array().max(1.0), 0.0);
  out.noise = covariance.diagonal().cwiseMax(kLeastNoise);
  if (const auto stood = bank.feature("repose_column_stood")) out.noise[static_cast<Index>(*stood)] = std::max(out.noise[static_cast<Index>(*stood)], kOfStood);
  const VectorXd root = out.noise.cwiseSqrt().cwiseInverse();
  out.correlation = (1 - kShrinkage) * (root.asDiagonal() * covariance * root.asDiagonal());
  out.correlation.diagonal().setOnes();
  out.correlation = made_sound(out.correlation);
  return out;
}

}  // namespace regolab::gap
