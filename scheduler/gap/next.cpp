#include "scheduler/gap/next.h"

#include <algorithm>
#include <cmath>

#include "scheduler/gap/candidate_tests.h"
#include "scheduler/gap/mixture.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kComponents = 96;        // draws of each hypothesis
constexpr int kDraws = 600;              // of the new measurement, over all causes
constexpr double kLeastProbability = 0.002, kLikely = 0.05;
constexpr double kToldApart = 0.5;       // share of the entropy of two causes alone
constexpr std::size_t kMostSplits = 3;
constexpr double kFurther = 3;           // times as many specimens again: half the error in all

/// All features of the emulator, as if none was measured: what errors they share.
Comparison every_feature(const Emulator& emulator) {
  std::vector<Feature> all;
  for (const FeatureInfo& f : emulator.features()) all.push_back({.id = f.id, .group = f.group});
  return compare(emulator, all, 1);
}

/// Covariance of what specimens do, of given variances. What codes differ by is none of it: it stays from test to test.
MatrixXd scatter(const Comparison& comparison, const VectorXd& variance) {
  const VectorXd sd = variance.cwiseSqrt();
  return sd.asDiagonal() * comparison.correlation * sd.asDiagonal();
}

/// One draw of one hypothesis, given what is measured.
struct Draw {
  double weight;
  VectorXd mean;             ///< [p] of the features, as emulated
  MatrixXd shared;           ///< [p][p] covariance of all but the specimens' own scatter
  VectorXd pull;             ///< [q] C_yy^-1 (y - mean)
  Eigen::LLT<MatrixXd> seen; ///< of C_yy
  double scale;              ///< of a Student t given a part of it
};

/// A new measurement: which features, and the covariance of its own scatter.
struct Planned {
  std::vector<Index> feature;
  MatrixXd own;
};

class Predictive {
 public:
  explicit Predictive(const NextQuestion& q) : q_(q), every_(every_feature(q.emulator)) {
    every_.same_code = q.comparison.same_code;
    library_ = library_covariance(q.emulator, every_, q.stated, q.seed);
    for (const Believed& b : q.believed) {
      if (b.probability < kLeastProbability) continue;
      auto known = std::ranges::find(causes_, b.cause);
      if (known == causes_.end()) causes_.push_back(b.cause), probability_.push_back(0), draws_.emplace_back(), known = causes_.end() - 1;
      const auto at = static_cast<std::size_t>(known - causes_.begin());
      probability_[at] += b.probability;
      add_draws(b, draws_[at]);
    }
    double sum = 0;
    for (const double p : probability_) sum += p;
    for (double& p : probability_) p /= sum;
  }

  const std::vector<std::string>& causes() const { return causes_; }
  const std::vector<double>& probability() const { return probability_; }

  Information of(const Planned& planned) const {
    std::vector<Mixture> densities;
    for (const auto& draws : draws_) {
      Mixture& mixture = densities.emplace_back(static_cast<Index>(planned.feature.size()));
      for (const Draw& draw : draws) add(draw, planned, mixture);
      mixture.smooth();
    }
    return information(densities, probability_, kDraws, q_.seed);
  }

  Planned plan(const CandidateTest& test) const {
    const Comparison fresh = compare(q_.emulator, test.features, q_.size_ratio);
    VectorXd variance = fresh.variance - fresh.between_alone;
    if (test.repeated) {
      for (Index k = 0; k < fresh.size(); ++k) {
        const auto at = std::ranges::find(q_.comparison.feature, fresh.feature[static_cast<std::size_t>(k)]) - q_.comparison.feature.begin();
        variance[k] = (q_.comparison.variance[at] - q_.comparison.between_alone[at]) / kFurther;
      }
    }
    return {fresh.feature, scatter(fresh, variance)};
  }

 private:
  void add_draws(const Believed& b, std::vector<Draw>& out) const {
    const Index n = std::min(kComponents, b.u.cols());
    MatrixXd u(b.u.rows(), n);
    for (Index k = 0; k < n; ++k) u.col(k) = b.u.col(k * b.u.cols() / n);
    const Likelihood likelihood(q_.emulator, every_, b.hypothesis, q_.stated, library_);
    const Foretold p = likelihood.predict(u);
    const auto& y = q_.comparison.feature;
    const MatrixXd own = scatter(q_.comparison, q_.comparison.variance - q_.comparison.between_alone);
    for (Index k = 0; k < n; ++k) {
      const double size = std::pow(likelihood.difference(u.col(k)), 2);
      MatrixXd shared = size * every_.between_codes;
      shared += likelihood.error(p, u, k);
      shared.diagonal() += size * every_.between_alone;
      if (b.hypothesis.unknown) shared += std::pow(likelihood.unknown_size(u.col(k)), 2) * library_;
      Eigen::LLT<MatrixXd> factor(shared(y, y) + own);
      const VectorXd off = q_.comparison.y - p.mean.col(k)(y), pull = factor.solve(off);
      const double scale = (kFreedom + off.dot(pull)) / (kFreedom + static_cast<double>(off.size()));
      out.push_back({b.probability / static_cast<double>(n), p.mean.col(k), std::move(shared), pull, std::move(factor), scale});
    }
  }

  /// Mean and covariance of the new measurement given the old one. A Student t of many degrees of freedom, taken as a normal.
  void add(const Draw& draw, const Planned& planned, Mixture& mixture) const {
    const MatrixXd across = draw.shared(planned.feature, q_.comparison.feature);
    const VectorXd mean = draw.mean(planned.feature) + across * draw.pull;
    MatrixXd covariance = draw.shared(planned.feature, planned.feature) + planned.own;
    covariance -= across * draw.seen.solve(across.transpose());
    mixture.add(draw.weight, mean, draw.scale * covariance);
  }

  const NextQuestion& q_;
  Comparison every_;
  MatrixXd library_;
  std::vector<std::string> causes_;
  std::vector<double> probability_;
  std::vector<std::vector<Draw>> draws_;  ///< of each cause
};

std::vector<std::string> splits_of(const Predictive& foretold, const Information& information) {
  std::vector<std::pair<double, std::string>> found;
  const auto& p = foretold.probability();
  for (std::size_t a = 0; a < p.size(); ++a) {
    for (std::size_t b = a + 1; b < p.size(); ++b) {
      if (std::min(p[a], p[b]) < kLikely || information.apart(static_cast<Index>(a), static_cast<Index>(b)) < kToldApart) continue;
      found.emplace_back(p[a] + p[b], p[a] >= p[b] ? foretold.causes()[a] + " | " + foretold.causes()[b] : foretold.causes()[b] + " | " + foretold.causes()[a]);
    }
  }
  std::ranges::sort(found, std::greater{});
  found.resize(std::min(found.size(), kMostSplits));
  std::vector<std::string> out;
  for (auto& [sum, text] : found) out.push_back(std::move(text));
  return out;
}

double probability_of(const Predictive& foretold, std::string_view cause) {
  double sum = 0;
  for (std::size_t k = 0; k < foretold.causes().size(); ++k) sum += foretold.causes()[k] == cause ? foretold.probability()[k] : 0;
  return sum;
}

/// Tests without an emulator whose causes are both likely.
void add_others(const Predictive& foretold, std::vector<NextTest>& out) {
  const auto likely = [&](std::string_view cause) {
    const double p = probability_of(foretold, cause);
    return cause.empty() || (p >= kLikely && p <= 1 - kLikely);
  };
  for (const OtherTest& test : other_tests()) {
    if (!likely(test.one) || !likely(test.other)) continue;
    std::string split = std::string(test.one) + " | " + (test.other.empty() ? "anything else" : std::string(test.other));
    const auto known = std::ranges::find(out, test.name, &NextTest::test);
    if (known != out.end()) known->splits.push_back(std::move(split));
    else out.push_back({.test = std::string(test.name), .nats = std::nullopt, .hours = test.hours, .splits = {std::move(split)}});
  }
}

}  // namespace

std::vector<NextTest> next_tests(const NextQuestion& question) {
  const Predictive foretold(question);
  std::vector<NextTest> out;
  for (const CandidateTest& test : candidate_tests(question.emulator, question.comparison, question.specimens, question.size_ratio)) {
    const Information told = foretold.of(foretold.plan(test));
    out.push_back({.test = test.name, .nats = told.nats, .nats_error = told.error, .hours = test.hours, .splits = splits_of(foretold, told)});
  }
  std::ranges::stable_sort(out, std::greater{}, [](const NextTest& t) { return *t.nats / t.hours; });
  add_others(foretold, out);
  return out;
}

double entropy_of_causes(const std::vector<Believed>& believed) {
  std::map<std::string, double> by_cause;
  for (const Believed& b : believed) by_cause[b.cause] += b.probability;
  double sum = 0, all = 0;
  for (const auto& [cause, p] : by_cause) all += p;
  for (const auto& [cause, p] : by_cause) sum -= p > 0 ? p / all * std::log(p / all) : 0;
  return sum;
}

}  // namespace regolab::gap
