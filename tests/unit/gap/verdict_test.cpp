#include "scheduler/gap/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::gap {
namespace {

Weighed model(const std::string& name, double log_z) { return {.model = name, .cause = cause_class(name), .log_z = log_z, .strength = {}}; }

double probability(const std::vector<Weighed>& models, const std::string& name) { return std::ranges::find(models, name, &Weighed::model)->probability; }

/// Evidence that is the same everywhere leaves priors: 0.20, 0.15, and the rest by class.
TEST(Weigh, EqualEvidenceGivesThePrior) {
  std::vector<Weighed> models = {model("none", 3), model("cohesion", 3), model("seating", 3), model("load_cell_gain", 3), model("wall_friction", 3), model("unknown", 3)};
  weigh(models, 1);
  const double all = 0.20 + 0.15 + 0.55;  // pairs that nobody tried take no part
  EXPECT_NEAR(probability(models, "none"), 0.20 / all, 1e-12);
  EXPECT_NEAR(probability(models, "unknown"), 0.15 / all, 1e-12);
  EXPECT_NEAR(probability(models, "cohesion"), 0.55 / 3 / all, 1e-12);
  EXPECT_NEAR(probability(models, "seating"), 0.55 / 6 / all, 1e-12) << "a class of two ways to be has no more than the others";
}

TEST(Weigh, OddsAreEvidenceOverTemperature) {
  std::vector<Weighed> models = {model("none", 0), model("cohesion", 6), model("unknown", 0)};
  weigh(models, 2);
  EXPECT_NEAR(probability(models, "cohesion") / probability(models, "none"), 0.55 / 0.20 * std::exp(3.0), 1e-9);
}

TEST(Doubt, AMisfitSpeaksForTheUnknownAsFarAsItsPAllows) {
  const auto after = [](double p) {
    std::vector<Weighed> models = {model("none", 0), model("cohesion", 20), model("unknown", 0)};
    weigh(models, 1);
    doubt(models, p);
    double sum = 0;
    for (const Weighed& m : models) sum += m.probability;
    EXPECT_NEAR(sum, 1, 1e-12);
    return models;
  };
  EXPECT_LT(probability(after(0.5), "unknown"), 1e-6);
  EXPECT_LT(probability(after(0.37), "unknown"), 1e-3) << "no step where the bound begins";
  EXPECT_NEAR(probability(after(0.01), "unknown"), 1 / (1 + 0.85 / 0.15 / (1 / (std::exp(1.0) * 0.01 * std::log(100.0)) - 1)), 1e-6);
  EXPECT_EQ(after(0.001).front().model, "unknown");
  const auto models = after(0.05);
  EXPECT_NEAR(probability(models, "cohesion") / probability(models, "none"), 0.55 / 0.20 * std::exp(20.0), 1e-3 * std::exp(20.0)) << "among the named nothing changes";
}

TEST(Mistrust, WhatFitsByTheEmulatorsErrorIsSharedWithTheUnknown) {
  std::vector<Weighed> models = {model("none", 0), model("breakage", 20), model("cohesion", 18), model("unknown", 0)};
  weigh(models, 1);
  const double breakage = probability(models, "breakage"), cohesion = probability(models, "cohesion"), unknown = probability(models, "unknown");
  std::ranges::find(models, "breakage", &Weighed::model)->vague = 0.7;
  std::ranges::find(models, "cohesion", &Weighed::model)->vague = 0.5;
  mistrust(models);
  EXPECT_NEAR(probability(models, "breakage"), 0.3 * breakage, 1e-12);
  EXPECT_NEAR(probability(models, "unknown"), unknown + 0.7 * breakage, 1e-12);
  EXPECT_EQ(probability(models, "cohesion"), cohesion) << "errors of half the variance are usual";
  EXPECT_EQ(models.front().model, "unknown");
}

Diagnosis diagnosis(std::vector<Weighed> models, double adequacy = 0.5, bool same_code = true) {
  Diagnosis d;
  d.same_code = same_code;
  d.models = std::move(models);
  weigh(d.models, 1);
  d.isolability = {{.effect = "cohesion", .sigma = 5, .twin = {}}};
  d.adequacy = adequacy, d.adequacy_threshold = 0.01;
  decide(d);
  return d;
}

TEST(Decide, SixVerdicts) {
  EXPECT_EQ(diagnosis({model("none", 20), model("cohesion", 0), model("unknown", 0)}).verdict, Verdict::kNoGap);
  const Diagnosis effect = diagnosis({model("none", 0), model("cohesion", 20), model("unknown", 0)});
  EXPECT_EQ(effect.verdict, Verdict::kEffect);
  EXPECT_EQ(effect.classes, std::vector<std::string>{"cohesion"});
  const Diagnosis pair = diagnosis({model("none", 0), model("cohesion", 5), model("wall_friction", 5), model("wall_friction+cohesion", 30), model("unknown", 0)});
  EXPECT_EQ(pair.verdict, Verdict::kPair);
  EXPECT_EQ(pair.classes, (std::vector<std::string>{"cohesion", "wall_friction"}));
  EXPECT_TRUE(pair.warnings.empty());
  const Diagnosis either = diagnosis({model("none", 0), model("cohesion", 20), model("wall_friction", 20), model("unknown", 0)});
  EXPECT_EQ(either.verdict, Verdict::kOneOf);
  EXPECT_EQ(either.classes.size(), 2u);
  EXPECT_EQ(diagnosis({model("none", 0), model("cohesion", 0), model("unknown", 20)}).verdict, Verdict::kNoneOfThese);
  EXPECT_EQ(diagnosis({model("none", 0), model("cohesion", 0), model("unknown", 0)}).verdict, Verdict::kCannotTell) << "nothing learned";
}

TEST(Decide, APairNoBetterThanItsBetterHalfSpeaksForThatHalf) {
  const Diagnosis d = diagnosis({model("none", 0), model("cohesion", 20), model("wall_friction", 0), model("wall_friction+cohesion", 22), model("unknown", 0)});
  EXPECT_EQ(d.models.front().cause, "cohesion+wall_friction");
  EXPECT_EQ(d.verdict, Verdict::kEffect);
  EXPECT_EQ(d.classes, std::vector<std::string>{"cohesion"});
}

TEST(Decide, OfStrangersDataAPairIsOneOfItsHalvesTheBetterFirst) {
  const Diagnosis d = diagnosis({model("none", 0), model("cohesion", 5), model("wall_friction", 9), model("wall_friction+cohesion", 30), model("unknown", 0)}, 0.5, false);
  EXPECT_EQ(d.verdict, Verdict::kOneOf);
  EXPECT_EQ(d.classes, (std::vector<std::string>{"wall_friction", "cohesion"}));
  ASSERT_EQ(d.warnings.size(), 1u);
  EXPECT_NE(d.warnings.front().find("cohesion+wall_friction"), std::string::npos);
}

TEST(Decide, ABestModelThatDoesNotFitIsNoneOfThese) {
  EXPECT_EQ(diagnosis({model("none", 0), model("cohesion", 20), model("unknown", 0)}, 0.001).verdict, Verdict::kNoneOfThese);
}

TEST(Decide, WhereNothingCanBeToldApartNothingIsTold) {
  Diagnosis d = diagnosis({model("none", 20), model("cohesion", 0), model("unknown", 0)});
  d.isolability.front().sigma = 1;
  decide(d);
  EXPECT_EQ(d.verdict, Verdict::kCannotTell);
}

TEST(CauseClass, OfAPairDoesNotDependOnItsOrder) {
  EXPECT_EQ(cause_class("seating+cohesion"), "apparatus+cohesion");
  EXPECT_EQ(cause_class("cohesion+load_cell_gain"), "apparatus+cohesion");
}

}  // namespace
}  // namespace regolab::gap
