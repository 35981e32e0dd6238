#include "scheduler/gap/repeats.h"

#include <cmath>
#include <map>

#include "scheduler/gap/covariances.h"
#include "vocab/effects.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kShrinkage = 0.02;    // of correlations, which three times as many pairs of runs as features foretell
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

}  // namespace

Repeats repeats_without_effects(const Bank& bank, const Space& space) {
  std::map<std::vector<double>, std::vector<VectorXd>> by_material;
  for (const BankRow& row : bank.rows) {
    if (!has_effect(bank, row)) by_material[row.inputs].push_back(features_of_row(row));
  }
  const auto n = static_cast<Index>(by_material.size()), p = static_cast<Index>(bank.features.size());
  Repeats out{MatrixXd(static_cast<Index>(space.size()), n), MatrixXd(n, p), VectorXd(n), VectorXd::Zero(p), MatrixXd::Constant(n, p, NAN), MatrixXd::Zero(p, p)};
  std::vector<VectorXd> deviations;
  Index i = 0;
  for (const auto& [inputs, runs] : by_material) {
    for (std::size_t k = 0; k < space.size(); ++k) out.values(static_cast<Index>(k), i) = inputs[*bank.input(space.axes[k].name)];
    const VectorXd mean = mean_of(runs);
    out.mean.row(i) = mean.transpose();
    out.weight[i++] = static_cast<double>(runs.size());
    if (runs.size() < 2) continue;
    const double unbiased = static_cast<double>(runs.size()) / static_cast<double>(runs.size() - 1);
    out.squares.row(i - 1).setZero();
    for (const VectorXd& run : runs) {
      deviations.push_back(std::sqrt(unbiased) * (run - mean));
      out.squares.row(i - 1) += deviations.back().cwiseAbs2().transpose() / static_cast<double>(runs.size());
    }
  }
  MatrixXd rows(static_cast<Index>(deviations.size()), p);
  for (Index r = 0; r < rows.rows(); ++r) rows.row(r) = deviations[static_cast<std::size_t>(r)].transpose();
  const MatrixXd covariance = paired_covariance(rows);
  out.noise = covariance.diagonal().cwiseMax(kLeastNoise);
  if (const auto stood = bank.feature("repose_column_stood")) out.noise[static_cast<Index>(*stood)] = std::max(out.noise[static_cast<Index>(*stood)], kOfStood);
  out.correlation = sound_correlation(covariance, out.noise, kShrinkage);
  return out;
}

}  // namespace regolab::gap
