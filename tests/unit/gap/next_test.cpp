#include "scheduler/gap/next.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scheduler/gap/candidate_tests.h"
#include "scheduler/gap/mixture.h"
#include "unit/gap/made_up_world.h"

namespace regolab::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Mixture normal(double mean, double sd) {
  Mixture out(1);
  out.add(1, VectorXd::Constant(1, mean), MatrixXd::Constant(1, 1, sd * sd));
  return out;
}

double density(double y, double mean, double sd) { return std::exp(-0.5 * std::pow((y - mean) / sd, 2)) / (sd * std::sqrt(2 * std::numbers::pi)); }

/// I(which; y) of normals by the trapezoid rule.
double by_quadrature(const std::vector<double>& means, const std::vector<double>& sds, const std::vector<double>& p) {
  double sum = 0;
  constexpr double kStep = 1e-3;
  for (double y = -30; y <= 30; y += kStep) {
    double all = 0;
    for (std::size_t k = 0; k < p.size(); ++k) all += p[k] * density(y, means[k], sds[k]);
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double f = density(y, means[k], sds[k]);
      if (f > 1e-300) sum += kStep * p[k] * f * std::log(f / all);
    }
  }
  return sum;
}

TEST(Information, OfNormalsIsWhatQuadratureGives) {
  const std::vector<double> means = {0, 1.5, -4}, sds = {1, 0.5, 2}, p = {0.5, 0.3, 0.2};
  std::vector<Mixture> densities;
  for (std::size_t k = 0; k < p.size(); ++k) densities.push_back(normal(means[k], sds[k]));
  const Information told = information(densities, p, 20000, 3);
  EXPECT_NEAR(told.nats, by_quadrature(means, sds, p), 4 * told.error);
  EXPECT_LT(told.error, 0.01);
  EXPECT_NEAR(told.apart(0, 1), by_quadrature({0, 1.5}, {1, 0.5}, {0.625, 0.375}) / 0.66156, 0.03);
}

TEST(Information, OfTheSameDensitiesIsNone) {
  const std::vector<Mixture> same = {normal(1, 2), normal(1, 2)};
  EXPECT_EQ(information(same, std::vector<double>{0.5, 0.5}, 500, 1).nats, 0);
}

TEST(Information, OfFarDensitiesIsTheWholeEntropy) {
  const std::vector<Mixture> far = {normal(-100, 1), normal(100, 1)};
  const std::vector<double> p = {0.25, 0.75};
  const Information told = information(far, p, 500, 1);
  EXPECT_NEAR(told.nats, -0.25 * std::log(0.25) - 0.75 * std::log(0.75), 1e-9);
  EXPECT_NEAR(told.apart(0, 1), 1, 1e-9);
}

TEST(Information, GrowsWithPrecision) {
  const std::vector<double> p = {0.5, 0.5};
  double before = 0;
  for (const double sd : {4.0, 2.0, 1.0, 0.5, 0.25}) {
    const std::vector<Mixture> two = {normal(0, sd), normal(1, sd)};
    const double now = information(two, p, 4000, 7).nats;
    EXPECT_GT(now, before) << sd;
    EXPECT_NEAR(now, by_quadrature({0, 1}, {sd, sd}, p), 0.03) << sd;
    before = now;
  }
}

/// y = a w + e with w known as N(0, 1) by draws alone: the smoothed mixture is the exact predictive N(0, a^2 + e^2), or nearly.
TEST(Mixture, OfDrawsOfALinearGaussianModelIsItsPredictive) {
  constexpr int kDraws = 96;
  const double slope = 3, noise = 0.3, sd = std::hypot(slope, noise);
  Mixture mixture(1);
  for (int k = 0; k < kDraws; ++k) {
    const double share = (k + 0.5) / kDraws;
    double low = -6, high = 6;
    for (int i = 0; i < 60; ++i) (0.5 * std::erfc(-0.5 * (low + high) / std::numbers::sqrt2) < share ? low : high) = 0.5 * (low + high);
    mixture.add(1, VectorXd::Constant(1, slope * low), MatrixXd::Constant(1, 1, noise * noise));
  }
  mixture.smooth();
  const MatrixXd y = MatrixXd::Random(1, 200) * 5;
  const VectorXd log_f = mixture.log_density(y);
  for (int i = 0; i < 200; ++i) EXPECT_NEAR(log_f[i], std::log(density(y(0, i), 0, sd)), 0.1) << y(0, i);
  const MatrixXd drawn = mixture.draws(4000, 1, 0);
  EXPECT_NEAR(std::sqrt(drawn.squaredNorm() / 4000), sd, 0.1);
}

/// What is believed after contacts and density alone, of the made-up world: nothing about cohesion, which shows in slopes alone.
struct Question {
  ObservationSet set = without(measured_in_made_up_world(0.6, 4, 0, 0), "repose_angle");
  Comparison comparison = compare(made_up_emulator(), set);
  std::map<std::string, Stated> stated;
  std::vector<Believed> believed;

  explicit Question(double cohesion_probability = 0.5, double low = 5000, double high = 10000) {
    add({"none", {}, false, {}}, "none", 1 - cohesion_probability);
    add({"cohesion", {0}, false, {{.low = low, .high = high, .logarithmic = true}}}, "cohesion", cohesion_probability);
  }
  static ObservationSet without(ObservationSet set, const std::string& id) {
    std::erase_if(set.scalars, [&](const Scalar& s) { return s.id == id; });
    return set;
  }
  void add(const Hypothesis& hypothesis, const std::string& cause, double probability) {
    const Likelihood likelihood(made_up_emulator(), comparison, hypothesis, stated);
    believed.push_back({hypothesis, cause, probability, sample_posterior(likelihood, likelihood.parameters(), {.particles = 200}).u});
  }
  std::vector<NextTest> ask(int specimens = 3) const { return next_tests({made_up_emulator(), comparison, stated, believed, specimens, 1, 1}); }
};

const NextTest& find(const std::vector<NextTest>& tests, const std::string& part) {
  const auto found = std::ranges::find_if(tests, [&](const NextTest& t) { return t.test.find(part) != std::string::npos; });
  EXPECT_NE(found, tests.end()) << part;
  static const NextTest none;
  return found == tests.end() ? none : *found;
}

TEST(NextTests, TheTestWhereTheCauseShowsComesFirst) {
  const Question question;
  const auto tests = question.ask();
  EXPECT_EQ(tests.front().test, "angle of repose");
  EXPECT_GT(tests.front().nats.value_or(0), 0.5);  // of ln 2
  EXPECT_EQ(tests.front().splits, std::vector<std::string>{"none | cohesion"});
  EXPECT_NEAR(entropy_of_causes(question.believed), std::log(2), 1e-12);
}

TEST(NextTests, MoreOfWhatDoesNotShowTheCauseTellsNothing) {
  const auto tests = Question().ask();
  for (const char* part : {"more specimens: density", "more specimens: contacts"}) {
    const NextTest& test = find(tests, part);
    EXPECT_LT(test.nats.value_or(1), 0.05) << part;
    EXPECT_TRUE(test.splits.empty()) << part;
  }
}

TEST(NextTests, AHypothesisIsNotToldFromItself) {
  Question question(0);
  question.believed.pop_back();
  question.believed.front().probability = 0.5;
  question.believed.push_back(question.believed.front());
  question.believed.back().cause = "the same";
  const Likelihood likelihood(made_up_emulator(), question.comparison, {"none", {}, false, {}}, question.stated);
  question.believed.back().u = sample_posterior(likelihood, likelihood.parameters(), {.particles = 200, .seed = 99}).u;
  for (const NextTest& test : question.ask()) EXPECT_LT(test.nats.value_or(1), 0.02) << test.test;
}

TEST(NextTests, WhatIsKnownNeedsNoTest) {
  for (const NextTest& test : Question(0.0001).ask()) EXPECT_LT(test.nats.value_or(0), 1e-3) << test.test;
}

TEST(NextTests, MoreSpecimensTellMoreAndCostMore) {
  const Question question(0.5, 50, 300);  // strong cohesion is told by one specimen
  const NextTest few = find(question.ask(1), "angle of repose"), many = find(question.ask(12), "angle of repose");
  EXPECT_GT(*many.nats, *few.nats);
  EXPECT_GT(many.hours, few.hours);
}

TEST(NextTests, WithoutAnEmulatorAreNamedOnlyForLikelyCauses) {
  EXPECT_TRUE(std::ranges::all_of(Question().ask(), [](const NextTest& t) { return t.nats.has_value(); }));  // cohesion alone: no pair
  Question question;
  question.believed.push_back(question.believed.front());
  question.believed.back().cause = "loading_rate", question.believed.back().probability = 0.5;
  const NextTest two_speeds = find(question.ask(), "two loading speeds");
  EXPECT_FALSE(two_speeds.nats);
  EXPECT_EQ(two_speeds.splits, std::vector<std::string>{"cohesion | loading_rate"});
}

TEST(CandidateTests, AreWhatIsMissingAndMoreOfWhatIsThere) {
  const Question question;
  const auto tests = candidate_tests(made_up_emulator(), question.comparison, 3, 1);
  ASSERT_EQ(tests.size(), 3U);
  EXPECT_FALSE(tests[0].repeated);
  EXPECT_EQ(tests[0].name, "angle of repose");
  EXPECT_TRUE(tests[1].repeated);
  EXPECT_EQ(tests[1].name, "9 more specimens: density of the poured bed");
  for (const CandidateTest& test : tests) EXPECT_GT(test.hours, 0);
}

}  // namespace
}  // namespace regolab::gap
