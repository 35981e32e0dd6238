#include "scheduler/gap/blind/baselines.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWithinChance = 0.05;
constexpr int kPolishings = 12, kAround = 60;
constexpr std::uint64_t kStream = 5000;

struct Best {
  VectorXd u;
  double value = -INFINITY;
};

/// The largest value over the unit cube: particles that walk uphill, then a search around the best of them.
Best maximum(const LogLikelihood& f, int parameters, std::uint64_t seed) {
  const Posterior walked = sample_posterior(f, parameters, {.particles = 150, .kept = 0.4, .moves = 2, .repeats = 1, .seed = seed});
  Index at = 0;
  Best best;
  best.value = walked.log_likelihood.maxCoeff(&at);
  best.u = walked.u.col(at);
  double reach = 0.1;
  for (int round = 0; round < kPolishings; ++round, reach *= 0.7) {
    MatrixXd u(parameters, kAround);
    for (Index i = 0; i < kAround; ++i) {
      const VectorXd step = reach * normals(parameters, seed + static_cast<std::uint64_t>(i), static_cast<int>(kStream) + round);
      u.col(i) = (best.u + step).cwiseMax(0.0).cwiseMin(1.0);
    }
    const VectorXd there = f(u);
    Index top = 0;
    if (const double value = there.maxCoeff(&top); value > best.value) best = {u.col(top), value};
  }
  return best;
}

std::string smallest_rms(const std::vector<Refit>& refits) { return std::ranges::min_element(refits, {}, &Refit::rms)->model; }

void weigh_by_bic(std::vector<Refit>& refits, double features) {
  const auto score = [&](const Refit& r) { return r.log_likelihood - 0.5 * r.parameters * std::log(features); };
  double top = -INFINITY, sum = 0;
  for (const Refit& r : refits) top = std::max(top, score(r));
  for (Refit& r : refits) sum += r.bic_probability = std::exp(score(r) - top);
  for (Refit& r : refits) r.bic_probability /= sum;
}

class Refitting {
 public:
  Refitting(const Emulator& emulator, const ObservationSet& set, std::uint64_t seed)
      : emulator_(emulator),
        comparison_(compare(emulator, set)),
        stated_(stated_in(set, emulator.space())),
        seed_(seed),
        sd_(comparison_.variance.cwiseSqrt()) {}

  Index features() const { return comparison_.size(); }

  Refit refit(const Hypothesis& hypothesis) {
    const Likelihood likelihood(emulator_, comparison_, hypothesis, stated_);
    const auto off = [&](const MatrixXd& u) -> MatrixXd {
      return sd_.cwiseInverse().asDiagonal() * (comparison_.y.replicate(1, u.cols()) - likelihood.predict(u).mean);
    };
    const LogLikelihood misfit = [&](const MatrixXd& u) -> VectorXd { return -0.5 * off(u).colwise().squaredNorm().transpose(); };
    const Best closest = maximum(misfit, likelihood.parameters(), seed_);
    const Best likely = maximum([&](const MatrixXd& u) { return likelihood(u); }, likelihood.parameters(), seed_ + 1);
    if (hypothesis.causes.empty()) left_ = off(closest.u), at_ = closest.u;
    return {.model = hypothesis.name,
            .rms = std::sqrt(-2 * closest.value / static_cast<double>(features())),
            .log_likelihood = likely.value,
            .parameters = likelihood.parameters()};
  }

  /// REQUIRES: the base model was refitted.
  double cosine(std::size_t cause) const {
    const Likelihood with(emulator_, comparison_, {.name = "", .causes = {cause}}, stated_),
        base(emulator_, comparison_, {.name = "none", .causes = {}}, stated_);
    const EffectInfo& effect = *emulator_.causes()[cause].effect;
    const double zero =
        effect.prior_low < 0 ? -effect.prior_low / (effect.prior_high - effect.prior_low) : 0;  // share of no effect: the mean is over one side
    constexpr int kStrengths = 9;
    MatrixXd u = at_.replicate(1, kStrengths);
    u.conservativeResize(at_.size() + 1, Eigen::NoChange);
    for (int k = 0; k < kStrengths; ++k) u(at_.size(), k) = zero + (1 - zero) * (k + 0.5) / kStrengths;
    const VectorXd shift = (sd_.cwiseInverse().asDiagonal() * (with.predict(u).mean.colwise() - VectorXd(base.predict(at_).mean))).rowwise().mean();
    const double c = shift.dot(left_) / std::max(1e-300, shift.norm() * left_.norm());
    return zero > 0 ? std::abs(c) : c;
  }

  double misfit() const { return left_.squaredNorm(); }

 private:
  const Emulator& emulator_;
  const Comparison comparison_;
  const std::map<std::string, Stated> stated_;
  const std::uint64_t seed_;
  const VectorXd sd_;
  VectorXd left_, at_;  // of the base model refitted: what it leaves [sd], and where
};

}  // namespace

Baselines baselines_of(const Emulator& emulator, const ObservationSet& set, std::uint64_t seed) {
  Baselines out;
  Refitting refitting(emulator, set, seed);
  if (refitting.features() == 0) return out;
  out.refits.push_back(refitting.refit({.name = "none", .causes = {}}));
  for (std::size_t c = 0; c < emulator.causes().size(); ++c) {
    out.refits.push_back(refitting.refit({.name = std::string(emulator.causes()[c].effect->name), .causes = {c}}));
    out.refits.back().cosine = refitting.cosine(c);
  }
  weigh_by_bic(out.refits, static_cast<double>(refitting.features()));
  out.base_misfit_p =
      boost::math::cdf(boost::math::complement(boost::math::chi_squared(static_cast<double>(refitting.features())), refitting.misfit()));
  out.lowest_rms = smallest_rms(out.refits);
  out.bic = std::ranges::max_element(out.refits, {}, &Refit::bic_probability)->model;
  out.nearest_pattern = out.base_misfit_p > kWithinChance ? "none" : std::ranges::max_element(out.refits, {}, &Refit::cosine)->model;
  return out;
}

}  // namespace regolab::gap
