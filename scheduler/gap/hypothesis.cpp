#include "scheduler/gap/hypothesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kUnknownScale = 2;    // of the half-Cauchy prior: how much larger than the library's shifts
constexpr double kMostUnknown = 50;
constexpr int kLibraryDraws = 400;
constexpr std::uint64_t kStream = 1000;
constexpr double kOtherLaw = 0.3;      // of a shift, as often as codes differ as they usually do: laws of one name are written in many ways
constexpr double kAnyDirection = 0.1;  // of the library's mean variance: directions that no effect makes

/// Normal quantile by bisection: few digits are needed, and none of the parameters' cost is here.
double normal_quantile(double u) {
  double low = -6, high = 6;
  for (int i = 0; i < 40; ++i) (0.5 * std::erfc(-0.5 * (low + high) / std::numbers::sqrt2) < u ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

}  // namespace

StrengthRange StrengthRange::of(const Cause& cause, double least) {
  const double low = cause.effect->prior_low, high = cause.effect->prior_high;
  if (low >= 0) return {std::clamp(least, low, high), high, low, std::clamp(least, low, high), cause.effect->logarithmic};
  return {low, high, std::max(low, -least), std::min(high, least), false};
}

double StrengthRange::at(double u) const {
  if (logarithmic) return low * std::pow(high / low, u);
  if (low >= 0) return low + (high - low) * u;
  const double negative = below - low, at = u * (negative + high - above);
  return at < negative ? low + at : above + (at - negative);
}

Likelihood::Likelihood(const Emulator& emulator, const Comparison& comparison, const Hypothesis& hypothesis, std::map<std::string, Stated> stated,
                       const MatrixXd& library)
    : emulator_(emulator), comparison_(comparison), hypothesis_(hypothesis), stated_(std::move(stated)), library_(library) {
  for (std::size_t k = hypothesis_.strength.size(); k < hypothesis_.causes.size(); ++k) {
    hypothesis_.strength.push_back(StrengthRange::of(emulator.causes()[hypothesis_.causes[k]]));
  }
  for (const std::size_t cause : hypothesis_.causes) go_together_.push_back(emulator.error_correlation(cause)(comparison.feature, comparison.feature));
  const auto& axes = emulator.space().axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto known = stated_.find(axes[k].name);
    if (known == stated_.end() || known->second.standard_error > 0) free_.push_back(k);
  }
}

int Likelihood::parameters() const { return static_cast<int>(free_.size() + 1 + hypothesis_.causes.size()) + (hypothesis_.unknown ? 1 : 0); }

MatrixXd Likelihood::values(const MatrixXd& u) const {
  const Space& space = emulator_.space();
  MatrixXd out(static_cast<Index>(space.size()), u.cols());
  for (std::size_t k = 0; k < space.size(); ++k) {
    const Axis& axis = space.axes[k];
    const auto known = stated_.find(axis.name);
    const auto at = std::ranges::find(free_, k);
    for (Index i = 0; i < u.cols(); ++i) {
      double value = 0;
      if (at == free_.end()) {
        value = known->second.value;
      } else {
        const double share = u(at - free_.begin(), i);
        value = known == stated_.end() ? space.value(k, share) : known->second.value + known->second.standard_error * normal_quantile(share);
      }
      out(static_cast<Index>(k), i) = axis.is_choice() ? value : std::clamp(value, axis.low, axis.high);
    }
  }
  return out;
}

VectorXd Likelihood::strength(const MatrixXd& u, std::size_t k) const {
  const StrengthRange& range = hypothesis_.strength[k];
  return u.row(static_cast<Index>(free_.size() + 1 + k)).transpose().unaryExpr([&](double share) { return range.at(share); });
}

double Likelihood::difference(const VectorXd& u) const { return (comparison_.same_code ? kMostOfOneCode : kMostDifferent) * u[static_cast<Index>(free_.size())]; }

double Likelihood::unknown_size(const VectorXd& u) const {
  const double share = std::min(u[u.size() - 1], 0.999);
  return std::min(kMostUnknown, kUnknownScale * std::tan(0.5 * std::numbers::pi * share));
}

Foretold Likelihood::predict(const MatrixXd& u) const {
  const MatrixXd material = values(u);
  const auto& of = comparison_.feature;
  const Predicted base = emulator_.predict(material);
  Foretold out{base.mean(of, Eigen::all), base.variance(of, Eigen::all), emulator_.noise_scale(material)(of, Eigen::all), {}};
  for (std::size_t k = 0; k < hypothesis_.causes.size(); ++k) {
    const Use use{hypothesis_.causes[k], strength(u, k)};
    const Predicted shift = emulator_.shift(material, use);
    const VectorXd full = emulator_.scatter(use.cause)(of).cwiseProduct(comparison_.share).cwiseSqrt();
    const auto growth = use.strength.unaryExpr([&](double s) { return std::abs(emulator_.causes()[use.cause].growth(s)); });
    out.effects.push_back({shift.mean(of, Eigen::all), shift.variance(of, Eigen::all).cwiseSqrt(), full * growth.transpose()});
    out.mean += out.effects.back().mean;
  }
  if (hypothesis_.offset_read) {
    for (Index k = 0; k < out.mean.rows(); ++k) {
      const Group& group = comparison_.measured[static_cast<std::size_t>(k)].group;
      if (comparison_.measured[static_cast<std::size_t>(k)].id.starts_with("sigma3_measured_ratio")) out.mean.row(k) += strength(u, 0).transpose() / group.sigma3;
    }
  }
  return out;
}

MatrixXd Likelihood::error(const Foretold& p, const MatrixXd& u, Index i) const {
  MatrixXd out = comparison_.base_error(p.variance.col(i));
  const double law = comparison_.same_code ? 0 : std::pow(kOtherLaw * difference(u.col(i)), 2);
  for (std::size_t k = 0; k < p.effects.size(); ++k) {
    const Foretold::Shift& effect = p.effects[k];
    const VectorXd scatter = effect.scatter.col(i), wrong = (effect.wrong.col(i).cwiseAbs2() + law * effect.mean.col(i).cwiseAbs2()).cwiseSqrt();
    out += wrong.asDiagonal() * go_together_[k] * wrong.asDiagonal();
    out += scatter.asDiagonal() * comparison_.correlation * scatter.asDiagonal();
  }
  return out;
}

MatrixXd Likelihood::covariance(const Foretold& p, const MatrixXd& u, Index i) const {
  MatrixXd out = comparison_.covariance(error(p, u, i), difference(u.col(i)), p.scale.col(i));
  if (hypothesis_.unknown) out += std::pow(unknown_size(u.col(i)), 2) * library_;
  return out;
}

VectorXd Likelihood::operator()(const MatrixXd& u) const {
  const Foretold p = predict(u);
  VectorXd out(u.cols());
  for (Index i = 0; i < u.cols(); ++i) out[i] = student_t_log_density(comparison_.y - p.mean.col(i), covariance(p, u, i));
  return out;
}

MatrixXd library_covariance(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed) {
  const auto q = comparison.size();
  MatrixXd sum = MatrixXd::Zero(q, q);
  const Likelihood base(emulator, comparison, {"none", {}, false, {}}, stated);
  for (std::size_t c = 0; c < emulator.causes().size(); ++c) {
    const Likelihood with(emulator, comparison, {"", {c}, false, {}}, stated);
    MatrixXd u(with.parameters(), kLibraryDraws);
    for (Index i = 0; i < u.cols(); ++i) {
      for (Index d = 0; d < u.rows(); ++d) {
        u(d, i) = uniform(seed, kStream + c, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(d));
      }
    }
    const MatrixXd shift = with.predict(u).mean - base.predict(u.topRows(base.parameters())).mean;
    sum += shift * shift.transpose() / static_cast<double>(u.cols());
  }
  sum /= static_cast<double>(std::max<std::size_t>(1, emulator.causes().size()));
  sum.diagonal() *= 1 + kAnyDirection;
  sum.diagonal() += 0.01 * comparison.variance;
  return sum;
}

std::map<std::string, Stated> stated_in(const ObservationSet& set, const Space& space) {
  std::map<std::string, Stated> out;
  if (set.material.nominal_max_size) out["L_S"] = {*set.material.nominal_max_size, 0};
  if (set.protocol.gravity) out["gravity"] = {*set.protocol.gravity, 0};
  for (const auto& [name, known] : set.material.micro) out[name] = {known.value, known.standard_error.value_or(0)};
  std::erase_if(out, [&](const auto& item) { return space.find(item.first) < 0; });
  return out;
}

}  // namespace regolab::gap
