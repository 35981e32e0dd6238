#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Upper tail of chi-square with n degrees of freedom, by Wilson and Hilferty's normal approximation (doi 10.1073/pnas.17.12.684).
double chi2_tail(double x, double n) {
  const double z = (std::cbrt(x / n) - (1 - 2 / (9 * n))) / std::sqrt(2 / (9 * n));
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// Two groups of one test and stress are looked at together only where they are the same; a group of the stress test is a part of its curve.
std::map<Group, std::vector<Index>> groups_of(const Comparison& comparison) {
  std::map<Group, std::vector<Index>> out;
  for (std::size_t k = 0; k < comparison.measured.size(); ++k) out[comparison.measured[k].group].push_back(static_cast<Index>(k));
  return out;
}

void adjust(std::vector<GroupGap>& gaps) {
  std::ranges::sort(gaps, {}, &GroupGap::p);
  const auto n = static_cast<double>(gaps.size());
  double least = 1;
  for (std::size_t k = gaps.size(); k-- > 0;) gaps[k].p_adjusted = least = std::min(least, gaps[k].p * n / static_cast<double>(k + 1));
}

}  // namespace

std::vector<GroupGap> locate(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, const SmcOptions& smc) {
  std::vector<GroupGap> out;
  for (const auto& [group, members] : groups_of(comparison)) {
    std::vector<Index> rest;
    for (Index k = 0; k < comparison.size(); ++k) {
      if (std::ranges::find(members, k) == members.end()) rest.push_back(k);
    }
    if (rest.empty()) continue;
    const Comparison others = comparison.subset(rest), own = comparison.subset(members);
    const Likelihood fit(emulator, others, {"none", {}, false, {}}, stated);
    const Posterior posterior = sample_posterior(fit, fit.parameters(), smc);
    const Likelihood look(emulator, own, {"none", {}, false, {}}, stated);
    const Foretold p = look.predict(posterior.u);
    const VectorXd mean = p.mean.rowwise().mean();
    const MatrixXd centred = p.mean.colwise() - mean;
    double size = 0;
    for (Index i = 0; i < posterior.u.cols(); ++i) size += std::pow(look.difference(posterior.u.col(i)), 2) / static_cast<double>(posterior.u.cols());
    const MatrixXd covariance = own.covariance(own.base_error(p.variance.rowwise().mean()), std::sqrt(size), p.scale.rowwise().mean()) + centred * centred.transpose() / static_cast<double>(p.mean.cols());
    const VectorXd off = own.y - mean;
    const double distance2 = off.dot(Eigen::LLT<MatrixXd>(covariance).solve(off)), n = static_cast<double>(members.size());
    Index worst = 0;
    const double largest = (off.array().square() / covariance.diagonal().array()).maxCoeff(&worst);
    const FeatureInfo& info = emulator.features()[static_cast<std::size_t>(own.feature[static_cast<std::size_t>(worst)])];
    GroupGap gap{.group = group, .feature = info.id, .text = info.difference(own.y[worst], mean[worst])};
    gap.shift_pct = 100 * (info.kind == Kind::kLog ? std::expm1(off[worst]) : off[worst] / std::max(1e-12, std::abs(mean[worst])));
    gap.z = std::copysign(std::sqrt(largest), off[worst]);
    gap.p = chi2_tail(distance2, n);
    out.push_back(std::move(gap));
  }
  adjust(out);
  return out;
}

}  // namespace regolab::gap
