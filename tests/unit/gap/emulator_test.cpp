#include "scheduler/gap/emulator.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "scheduler/gap/diagnosis.h"
#include "unit/gap/made_up_world.h"

namespace regolab::gap {
namespace {

const Emulator& emulator() { return made_up_emulator(); }
ObservationSet measured(double friction, double elements, double cohesion, double density) { return measured_in_made_up_world(friction, elements, cohesion, density); }

Eigen::MatrixXd material(double friction, double elements) {
  Eigen::MatrixXd out(2, 1);
  out << friction, elements;
  return out;
}

TEST(Emulator, PredictsMaterialsItHasNotSeen) {
  const Predicted p = emulator().predict(material(0.47, 4));
  const auto truth = MadeUpWorld::measure(0.47, 4, 0, 0, 5);
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(p.mean(j, 0), truth[static_cast<std::size_t>(j)], 3 * std::sqrt(p.variance(j, 0) + emulator().noise()[j])) << j;
    EXPECT_LT(p.variance(j, 0), 2 * emulator().noise()[j]) << j;
  }
}

TEST(Emulator, AnEffectOfNoStrengthIsNoEffect) {
  for (std::size_t c = 0; c < emulator().causes().size(); ++c) {
    const Use none{c, Eigen::VectorXd::Zero(1)};
    EXPECT_EQ(emulator().predict(material(0.3, 2), std::span(&none, 1)).mean, emulator().predict(material(0.3, 2)).mean);
  }
}

TEST(Emulator, EffectsMoveWhatTheyMove) {
  ASSERT_EQ(emulator().causes()[0].effect->name, "cohesion");
  const Use strong{0, Eigen::VectorXd::Constant(1, 5000.0)};
  const Eigen::VectorXd shift = emulator().predict(material(0.5, 4), std::span(&strong, 1)).mean - emulator().predict(material(0.5, 4)).mean;
  EXPECT_NEAR(shift[2], 0.15 * std::log1p(5000.0 / 600), 0.06);
  EXPECT_NEAR(shift[0], 0, 0.04);
}

/// Two runs of each cohesive material whose slopes lie 0.2 to either side, in proportion to the effect.
TEST(Emulator, KnowsWhatEffectsScatterMore) {
  MadeUpWorld world;
  const double middle = std::sqrt(20.0 * 20000);
  for (std::size_t k = 0, n = world.bank.rows.size(); k < n; ++k) {
    BankRow& row = world.bank.rows[k];
    if (row.inputs[2] == 0) continue;
    const double off = 0.2 * std::log1p(row.inputs[2] / middle) / std::log1p(20000 / middle);
    BankRow twin = row;
    twin.seed = 2, twin.features[2] -= off;
    row.features[2] += off;
    world.bank.rows.push_back(twin);
  }
  const auto rough = Emulator::from(world.bank);
  EXPECT_LT(emulator().scatter(0)[2], 2 * emulator().noise()[2]);
  EXPECT_NEAR(rough->scatter(0)[2], 0.2 * 0.2, 0.02);
  EXPECT_LT(rough->scatter(0)[0], 2 * rough->noise()[0]);
}

TEST(Likelihood, HoldsTheScatterOfItsEffects) {
  Comparison c = compare(emulator(), measured(0.6, 4, 0, 0));
  const Likelihood with(emulator(), c, {"cohesion", {0}, false, {}}, {});
  Eigen::MatrixXd u = Eigen::MatrixXd::Constant(with.parameters(), 1, 0.5);
  const Eigen::MatrixXd three = with.error(with.predict(u), u, 0);
  c.share *= 3;
  const double strength = with.strength(u, 0)[0], growth = emulator().causes()[0].growth(strength);
  const Eigen::VectorXd more = (with.error(with.predict(u), u, 0) - three).diagonal();
  EXPECT_TRUE(more.isApprox(2.0 / 3 * growth * growth * emulator().scatter(0)(c.feature), 1e-9)) << "of one specimen instead of three";
}

TEST(Likelihood, ErrorsOfEachEffectGoTogetherInTheirOwnWay) {
  ObservationSet set = measured(0.6, 4, 0, 0);
  set.source = kSameCode;
  const Comparison c = compare(emulator(), set);
  const Likelihood base(emulator(), c, {"none", {}, false, {}}, {}), with(emulator(), c, {"cohesion", {0}, false, {}}, {});
  const Eigen::MatrixXd own = emulator().error_correlation(0);
  EXPECT_NEAR((own.diagonal() - Eigen::VectorXd::Ones(own.rows())).norm(), 0, 1e-9);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(own).eigenvalues().minCoeff(), 0);
  const Eigen::MatrixXd u = Eigen::MatrixXd::Constant(with.parameters(), 1, 0.5), before = u.topRows(base.parameters());
  const Foretold p = with.predict(u);
  const Eigen::VectorXd wrong = p.effects[0].wrong.col(0), scatter = p.effects[0].scatter.col(0);
  const Eigen::MatrixXd added = wrong.asDiagonal() * own(c.feature, c.feature) * wrong.asDiagonal(), more = scatter.asDiagonal() * c.correlation * scatter.asDiagonal();
  EXPECT_GT(wrong.maxCoeff(), 0);
  EXPECT_TRUE(with.error(p, u, 0).isApprox(base.error(base.predict(before), before, 0) + added + more, 1e-9));
}

TEST(Likelihood, AnotherCodesLawOfTheSameNameMayShiftOtherwise) {
  ObservationSet set = measured(0.6, 4, 0, 0);
  const Comparison stranger = compare(emulator(), set);
  set.source = kSameCode;
  const Comparison own = compare(emulator(), set);
  const Hypothesis cohesion{"cohesion", {0}, false, {}};
  const Likelihood theirs(emulator(), stranger, cohesion, {}), ours(emulator(), own, cohesion, {});
  const Eigen::MatrixXd u = Eigen::MatrixXd::Constant(theirs.parameters(), 1, 0.5);
  const Foretold p = theirs.predict(u);
  const Eigen::VectorXd more = (theirs.error(p, u, 0) - ours.error(p, u, 0)).diagonal().cwiseSqrt();
  EXPECT_TRUE(more.isApprox(0.3 * theirs.difference(u.col(0)) * p.effects[0].mean.col(0).cwiseAbs(), 1e-6));
}

/// Data of our own code fit best where codes do not differ, and a code that is off by two runs' scatter where they do.
TEST(Likelihood, LearnsHowMuchCodesDiffer) {
  const auto best_difference = [](double off) {
    ObservationSet set = measured(0.6, 4, 0, 0);
    set.scalars[1].value += off * std::sqrt(emulator().noise()[1]);
    const Comparison c = compare(emulator(), set);
    const Likelihood base(emulator(), c, {"none", {}, false, {}}, {{"theta_F", {0.6, 0}}, {"N_E", {4, 0}}});
    EXPECT_EQ(base.parameters(), 1);
    Eigen::MatrixXd u = Eigen::RowVectorXd::LinSpaced(50, 0, 0.98);
    Eigen::Index best = 0;
    base(u).maxCoeff(&best);
    return base.difference(u.col(best));
  };
  EXPECT_LT(best_difference(0), 0.2);
  EXPECT_GT(best_difference(3), 0.5);
}

TEST(Emulator, KeptKernelsGiveTheSameBits) {
  const MadeUpWorld world;
  const auto again = Emulator::from(world.bank, emulator().kernels());
  EXPECT_EQ(again->predict(material(0.2, 6)).mean, emulator().predict(material(0.2, 6)).mean);
}

TEST(Diagnosis, NamesAStrongEffectAndItsStrength) {
  const auto found = diagnose(emulator(), measured(0.6, 4, 5000, 0), {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->verdict, Verdict::kEffect);
  ASSERT_EQ(found->classes, std::vector<std::string>{"cohesion"});
  const Strength& s = found->models.front().strength.front();
  EXPECT_LT(s.low, 5000);
  EXPECT_GT(s.high, 5000);
}

TEST(Diagnosis, DoesNotNameAnEffectWhereThereIsNone) {
  const auto found = diagnose(emulator(), measured(0.6, 4, 0, 0), {});
  ASSERT_TRUE(found.ok());
  EXPECT_TRUE(found->verdict != Verdict::kEffect && found->verdict != Verdict::kNoneOfThese) << name_of(found->verdict);
  EXPECT_GT(found->adequacy, 0.05);
}

TEST(Diagnosis, SaysNoneOfTheseWhereNothingFits) {
  ObservationSet odd = measured(0.6, 4, 0, 0);
  odd.scalars[0].value += 3;  // contacts that no effect makes
  const auto found = diagnose(emulator(), odd, {});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->verdict, Verdict::kNoneOfThese);
}

TEST(Diagnosis, KeepsDrawsOfEveryModelWithinItsPrior) {
  const auto found = diagnose(emulator(), measured(0.6, 4, 5000, 0), {});
  for (const Weighed& m : found->models) {
    ASSERT_EQ(m.draws.size(), static_cast<std::size_t>(kDraws)) << m.model;
    for (const Draw& draw : m.draws) {
      ASSERT_EQ(draw.values.size(), emulator().space().size());
      EXPECT_EQ(draw.strength.size(), m.strength.size());
      EXPECT_TRUE(draw.values[1] == 2 || draw.values[1] == 4 || draw.values[1] == 6) << "a choice";
    }
  }
  const Weighed& best = found->models.front();
  ASSERT_EQ(best.model, "cohesion");
  EXPECT_NE(best.draws.front().strength, best.draws.back().strength);
  double mean = 0;
  for (const Draw& draw : best.draws) mean += std::log(draw.strength[0]) / kDraws;
  EXPECT_NEAR(mean, std::log(best.strength[0].median), 1);
}

/// Stopped after each of its steps in turn, and taken up again.
TEST(Diagnosis, TakenUpAgainEndsWithTheSameBits) {
  const ObservationSet set = measured(0.6, 4, 5000, 0);
  std::vector<std::pair<std::string, std::string>> kept;
  const auto memory_of = [&](std::size_t first) {
    return StepMemory{.find = [&kept, first](const std::string& name) -> std::optional<std::string> {
                        for (std::size_t k = 0; k < std::min(first, kept.size()); ++k) {
                          if (kept[k].first == name) return kept[k].second;
                        }
                        return std::nullopt;
                      },
                      .keep = {}};
  };
  StepMemory record{.find = {}, .keep = [&](const std::string& name, const std::string& bytes) { kept.emplace_back(name, bytes); }};
  DiagnosisOptions options;
  options.memory = &record;
  const auto whole = diagnose(emulator(), set, options);
  ASSERT_GE(kept.size(), whole->models.size() + 1) << "every hypothesis, and where";
  for (std::size_t first = 0; first <= kept.size(); ++first) {
    const StepMemory memory = memory_of(first);
    options.memory = &memory;
    const auto again = diagnose(emulator(), set, options);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->adequacy, whole->adequacy) << first;
    for (std::size_t k = 0; k < whole->models.size(); ++k) {
      EXPECT_EQ(again->models[k].model, whole->models[k].model);
      EXPECT_EQ(again->models[k].log_z, whole->models[k].log_z) << first;
      EXPECT_EQ(again->models[k].draws.back().values, whole->models[k].draws.back().values) << first;
    }
    ASSERT_EQ(again->where.size(), whole->where.size());
    for (std::size_t k = 0; k < whole->where.size(); ++k) EXPECT_EQ(again->where[k].p, whole->where[k].p);
  }
  const StepMemory all = memory_of(kept.size());
  options.memory = &all;
  const auto where = locate(emulator(), set, options);
  ASSERT_EQ(where->size(), whole->where.size());
  EXPECT_EQ(where->front().text, whole->where.front().text);
}

TEST(Diagnosis, TheSameSeedGivesTheSameAnswer) {
  const auto a = diagnose(emulator(), measured(0.6, 4, 300, 0), {}), b = diagnose(emulator(), measured(0.6, 4, 300, 0), {});
  ASSERT_EQ(a->models.size(), b->models.size());
  for (std::size_t k = 0; k < a->models.size(); ++k) EXPECT_EQ(a->models[k].log_z, b->models[k].log_z);
}

TEST(Diagnosis, NothingToCompareIsAnError) {
  ObservationSet set;
  set.scalars.push_back({.id = "sigma1_at_sigma3_7kPa", .value = 9, .unit = "Pa", .unit_as_read = "Pa", .standard_error = 1, .definition = {}, .sigma3 = 7000});
  EXPECT_EQ(diagnose(emulator(), set, {}).error().code, Code::kFailedPrecondition);
}

TEST(Comparison, TakesCohesionAndFrictionAngleAsTwoFeaturesThatErrTogether) {
  ObservationSet set;
  const auto scalar = [&](const char* id, double value, const char* unit, double error) {
    set.scalars.push_back({.id = id, .value = value, .unit = unit, .unit_as_read = unit, .standard_error = error, .definition = {}});
  };
  scalar("bulk_density", 1580, "kg/m3", 5), scalar("cohesion", 1000, "Pa", 300), scalar("friction_angle_internal", 0.7, "rad", 0.001);
  const Comparison c = compare(strength_emulator(), set);
  ASSERT_EQ(c.size(), 3);
  EXPECT_EQ(c.measured[1].id, "sigma1_ratio_1.25");
  EXPECT_NEAR(c.measured[1].value, std::log(std::pow(std::tan(0.7853981634 + 0.35), 2) + 2 * 1000 * std::tan(0.7853981634 + 0.35) / 1250), 1e-9);
  EXPECT_EQ(c.correlation(0, 1), 0);  // a balance and a load cell
  const double together = c.correlation(1, 2) * std::sqrt(c.variance[1] * c.variance[2]);
  EXPECT_NEAR(together, c.measured[1].standard_error * c.measured[2].standard_error, 0.01 * together);  // the cohesion's error moves both
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(c.covariance(Eigen::MatrixXd(Eigen::MatrixXd::Zero(3, 3)))).eigenvalues().minCoeff(), 0);
}

TEST(Comparison, ABedOfHeavierGrainsIsComparedByItsShareOfGrains) {
  ObservationSet set;
  set.scalars.push_back({.id = "bulk_density", .value = 1600, .unit = "kg/m3", .unit_as_read = "kg/m3", .standard_error = 5, .definition = {}});
  EXPECT_EQ(compare(strength_emulator(), set).y[0], 1600);
  set.material.grain_density = Known{.value = 2930 * 1.1, .standard_error = 0.0, .unit = "kg/m3"};
  EXPECT_NEAR(compare(strength_emulator(), set).y[0], 1600 / 1.1, 1e-9);
}

}  // namespace
}  // namespace regolab::gap
