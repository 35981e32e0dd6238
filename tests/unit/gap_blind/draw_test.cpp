/// Truths: what is drawn, that it can be run, and that unknowns are unknown.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "scheduler/design/design_file.h"
#include "scheduler/gap/blind/draw.h"
#include "scheduler/gap/blind/parts.h"
#include "scheduler/gap/blind/unknown_kinds.h"
#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

const std::string kSecret(32, 's');

/// Effects that stand out in proportion to their share of the prior, the more so the rougher the material; the weakest counts.
double sight(const Truth& t) {
  double out = t.effects.empty() ? 0 : INFINITY;
  for (const auto& [name, strength] : t.effects) {
    const EffectInfo& e = *find_effect(name);
    const double share = e.logarithmic ? std::log(strength / e.prior_low) / std::log(e.prior_high / e.prior_low) : std::abs(strength) / std::max(-e.prior_low, e.prior_high);
    out = std::min(out, 8 * share * (0.5 + t.material.friction_deg / 60));
  }
  return out;
}
std::vector<Truth> draw(const BlindPlan& plan, const std::string& secret) { return draw_truths(plan, secret, sight); }

std::map<TruthKind, int> counts_of(const std::vector<Truth>& truths, bool extra) {
  std::map<TruthKind, int> out;
  for (const Truth& t : truths) {
    if (t.extra == extra) ++out[t.kind];
  }
  return out;
}

TEST(Draw, TheWholeSetIsComposedAsTheDesignSays) {
  const auto truths = draw({}, kSecret);
  ASSERT_EQ(truths.size(), 156U);
  EXPECT_EQ(counts_of(truths, false),
            (std::map<TruthKind, int>{{TruthKind::kNull, 14}, {TruthKind::kEffect, 55}, {TruthKind::kPair, 12}, {TruthKind::kUnknown, 15}}));
  EXPECT_EQ(counts_of(truths, true), (std::map<TruthKind, int>{{TruthKind::kNull, 60}}));
  std::map<std::string, int> causes;
  std::set<std::string> unknown, ids, nonces;
  for (const Truth& t : truths) {
    if (t.kind == TruthKind::kEffect) ++causes[answer_of(t)];
    if (t.kind == TruthKind::kUnknown) unknown.insert(t.unknown);
    ids.insert(t.id), nonces.insert(t.nonce);
  }
  EXPECT_EQ(causes.size(), 12U);
  for (const auto& [cause, n] : causes) EXPECT_TRUE(n == 4 || n == 5) << cause;
  EXPECT_EQ(unknown.size(), unknown_kinds().size());
  EXPECT_EQ(ids.size(), 156U);
  EXPECT_EQ(nonces.size(), 156U);
}

TEST(Draw, PartsOfAnyNumberAddUp) {
  for (int n = 0; n < 200; ++n) {
    const Composition c = composition_of(n);
    EXPECT_EQ(c.effects + c.nulls + c.unknowns + c.pairs, n);
    EXPECT_GE(std::min({c.effects, c.nulls, c.unknowns, c.pairs}), 0);
  }
}

TEST(Draw, EqualSecretsGiveEqualSetsAndOthersDiffer) {
  EXPECT_EQ(draw({.cases = 12, .nulls = 3}, kSecret), draw({.cases = 12, .nulls = 3}, kSecret));
  const auto a = draw({.cases = 12, .nulls = 3}, kSecret), b = draw({.cases = 12, .nulls = 3}, std::string(32, 't'));
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NE(a[k].id, b[k].id);
}

TEST(Draw, NothingOfTheBankIsUsedAgain) {
  for (const Truth& t : draw({}, kSecret)) {
    EXPECT_NE(t.particles, 300);
    EXPECT_GE(t.particles, 260);
    EXPECT_LE(t.particles, 360);
    EXPECT_GE(t.step_fraction, 0.08);
    EXPECT_LE(t.step_fraction, 0.18);
    EXPECT_EQ(t.seeds.size(), 3U);
    for (const std::uint64_t seed : t.seeds) EXPECT_GE(seed, 1000000U);
  }
}

TEST(Draw, StrengthsLieInTheirPriorsAndFillThem) {
  std::map<std::string, std::vector<double>> shares;
  for (int set = 0; set < 8; ++set) {
    for (const Truth& t : draw({}, std::string(32, static_cast<char>('a' + set)))) {
      for (const auto& [name, strength] : t.effects) {
        const EffectInfo& effect = *find_effect(name);
        EXPECT_GE(strength, effect.prior_low * (effect.prior_low > 0 ? 0.9999 : 1.0001)) << name;
        EXPECT_LE(strength, effect.prior_high * 1.0001) << name;
        const double u = effect.logarithmic ? std::log(strength / effect.prior_low) / std::log(effect.prior_high / effect.prior_low)
                                            : (strength - effect.prior_low) / (effect.prior_high - effect.prior_low);
        if (t.kind == TruthKind::kEffect) shares[name].push_back(u);
      }
      EXPECT_EQ(t.kind == TruthKind::kPair, t.effects.size() == 2 && cause_class(t.effects.begin()->first) != cause_class(t.effects.rbegin()->first));
    }
  }
  for (const char* name : {"cohesion", "rolling_resistance", "breakage", "size_distribution"}) {
    const auto& u = shares.at(name);
    EXPECT_LT(*std::ranges::min_element(u), 0.2) << name;
    EXPECT_GT(*std::ranges::max_element(u), 0.8) << name;
  }
}

TEST(Draw, SinglesAreWeakMediumAndStrongInTurnAndPairsStrong) {
  std::map<int, int> strata;
  std::map<std::string, std::set<int>> of_class;
  for (const Truth& t : draw({}, kSecret)) {
    const double isolability = sight(t);
    if (t.kind == TruthKind::kPair) { EXPECT_GE(isolability, 4); }
    if (t.kind != TruthKind::kEffect) continue;
    EXPECT_GE(isolability, 1);
    const int stratum = isolability < 2 ? 0 : isolability < 4 ? 1 : 2;
    ++strata[stratum], of_class[answer_of(t)].insert(stratum);
  }
  for (const int stratum : {0, 1, 2}) EXPECT_NEAR(strata[stratum], 55 / 3.0, 1) << stratum;
  for (const auto& [name, met] : of_class) EXPECT_EQ(met.size(), 3U) << name;
}

TEST(Draw, WhatNoMaterialShowsIsDrawnAsClearAsItGets) {
  const auto dim = [](const Truth& t) { return 0.1 * sight(t); };  // never above 1.2
  std::vector<double> pairs;
  for (const Truth& t : draw_truths({.cases = 24, .nulls = 0}, kSecret, dim)) {
    if (t.kind == TruthKind::kPair) pairs.push_back(dim(t));
  }
  ASSERT_EQ(pairs.size(), 3U);
  for (const double isolability : pairs) EXPECT_GT(isolability, 0.5) << "the best of many tries";
}

TEST(Draw, HalfOfTheLawsThatHaveASecondVariantUseIt) {
  int second = 0, all = 0;
  for (int set = 0; set < 12; ++set) {
    for (const Truth& t : draw({.cases = 96, .nulls = 0}, std::string(32, static_cast<char>('A' + set)))) {
      const bool has = t.effects.contains("cohesion") || t.effects.contains("rolling_resistance");
      EXPECT_TRUE(has || t.variants.empty());
      all += has, second += !t.variants.empty();
    }
  }
  EXPECT_NEAR(static_cast<double>(second) / all, 0.5, 0.2);
}

TEST(Draw, TruthsTravelAsText) {
  for (const Truth& t : draw({.development = true}, kSecret)) {
    const auto back = truth_from(truth_text(t));
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(*back, t);
  }
  EXPECT_EQ(truth_from("{}").error().code, Code::kDataLoss);
  EXPECT_EQ(truth_from("not json").error().code, Code::kDataLoss);
}

/// A truth of every kind of departure, each effect and each unknown.
std::vector<Truth> one_of_each() {
  std::vector<Truth> out;
  std::set<std::string> seen;
  for (int set = 0; set < 40; ++set) {
    for (Truth& t : draw({}, std::string(32, static_cast<char>(' ' + set)))) {
      std::string what = std::string(name_of(t.kind)) + t.unknown;
      if (t.kind == TruthKind::kEffect) what += t.effects.begin()->first + (t.variants.empty() ? "" : t.variants.begin()->second);
      if (seen.insert(what).second) out.push_back(std::move(t));
    }
  }
  EXPECT_EQ(seen.size(), 2 + 16 + 2 + unknown_kinds().size()) << "nulls and pairs, effects, second variants, unknowns";
  return out;
}

TEST(Parts, EveryTruthIsADesignThatCanRun) {
  for (const Truth& truth : one_of_each()) {
    std::set<double> said;
    int beds = 0;
    const auto parts = parts_of(truth);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const BlindDesign made = design_of(truth, k);
      const auto design = read_design({.text = made.yaml, .file_name = "case.yaml", .attachments = {{"case.csv", made.table}}}, {});
      for (const Diagnostic& d : design.diagnostics) ADD_FAILURE() << truth_text(truth) << to_text(d);
      ASSERT_TRUE(design.ok());
      ASSERT_EQ(design.value->points.size(), 1U);
      const DesignPoint& point = design.value->points.front();
      EXPECT_EQ(point.numerics.clusters, truth.particles);
      EXPECT_EQ(point.numerics.step_fraction, truth.step_fraction);
      EXPECT_EQ(point.numerics.stress_stiffness_number, 0);
      EXPECT_EQ(point.numerics.isotropic_servo_steps, 200);
      EXPECT_EQ(design.value->seeds, truth.seeds);
      for (const auto& [name, strength] : truth.effects)
        EXPECT_NEAR(point.effects[find_effect(name)->id], strength, 1e-9 * std::abs(strength)) << name;
      for (const auto& [name, law] : truth.variants) EXPECT_EQ(point.effects[find_effect(name)->id], 1) << law;
      EXPECT_TRUE(truth.kind != TruthKind::kUnknown || !point.effects.any());
      EXPECT_EQ(design.value->repose, parts[k].bed);
      beds += parts[k].bed;
      for (const StressLevel& level : parts[k].stress) EXPECT_TRUE(said.insert(level.said).second);
    }
    EXPECT_EQ(beds, 1);
    EXPECT_THAT(said, ::testing::ElementsAre(1250, 2500, 5000, 10000));
  }
}

TEST(UnknownKinds, AreInNoLibraryAndAreToldApart) {
  std::set<std::string_view> names;
  for (const UnknownKind& kind : unknown_kinds()) {
    EXPECT_EQ(find_effect(kind.name), nullptr) << kind.name;
    EXPECT_TRUE(names.insert(kind.name).second);
    EXPECT_FALSE(kind.what.empty() || kind.nearest.empty() || kind.parameters.empty());
    Truth t{.id = "x", .kind = TruthKind::kUnknown, .unknown = std::string(kind.name)};
    Chance chance(kSecret, "x");
    kind.draw(chance, t);
    EXPECT_FALSE(t.parameters.empty()) << kind.name;
  }
}

}  // namespace
}  // namespace regolab::gap
