/// What counts as right: the table of marks.h, line by line.
#include "scheduler/gap/blind/marks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::gap {
namespace {

Truth null_truth() { return {.id = "n", .kind = TruthKind::kNull}; }
Truth unknown_truth() { return {.id = "u", .kind = TruthKind::kUnknown, .unknown = "batches"}; }
Truth effect_truth(const std::string& effect, double strength) { return {.id = "e", .kind = TruthKind::kEffect, .effects = {{effect, strength}}}; }
Truth pair_truth() { return {.id = "p", .kind = TruthKind::kPair, .effects = {{"wall_friction", 0.4}, {"cohesion", 500}}}; }

Answer answer(Verdict verdict, std::vector<std::string> classes) {
  Answer out;
  out.diagnosis.verdict = verdict, out.diagnosis.classes = std::move(classes);
  return out;
}

Mark marked(const Truth& truth, const Answer& given, double isolability = 5) {
  const bool effect = truth.kind == TruthKind::kEffect || truth.kind == TruthKind::kPair;
  return mark_of(truth, given, effect ? std::optional(TrueGap{isolability, "settle"}) : std::nullopt, std::nullopt);
}

TEST(Marks, EachVerdictIsRightWhereTheTableSays) {
  const Truth cohesion = effect_truth("cohesion", 500);
  const struct {
    Verdict verdict;
    std::vector<std::string> classes;
    bool null, effect, pair, unknown;
  } kTable[] = {
      {Verdict::kNoGap, {"none"}, true, false, false, false},
      {Verdict::kEffect, {"cohesion"}, false, true, false, false},
      {Verdict::kEffect, {"breakage"}, false, false, false, false},
      {Verdict::kOneOf, {"none", "cohesion"}, true, false, false, false},
      {Verdict::kOneOf, {"cohesion", "none"}, false, true, false, false},
      {Verdict::kOneOf, {"unknown", "cohesion"}, false, false, false, true},
      {Verdict::kOneOf, {"cohesion+wall_friction", "cohesion"}, false, false, true, false},
      {Verdict::kPair, {"cohesion", "wall_friction"}, false, false, true, false},
      {Verdict::kPair, {"wall_friction", "cohesion"}, false, false, true, false},
      {Verdict::kPair, {"cohesion", "breakage"}, false, false, false, false},
      {Verdict::kNoneOfThese, {"unknown"}, false, false, false, true},
      {Verdict::kCannotTell, {}, false, false, false, false},
  };
  for (const auto& row : kTable) {
    const Answer given = answer(row.verdict, row.classes);
    const std::string what = std::string(name_of(row.verdict)) + (row.classes.empty() ? "" : " " + row.classes[0]);
    EXPECT_EQ(marked(null_truth(), given).right, row.null) << what;
    EXPECT_EQ(marked(cohesion, given).right, row.effect) << what;
    EXPECT_EQ(marked(pair_truth(), given).right, row.pair) << what;
    EXPECT_EQ(marked(unknown_truth(), given).right, row.unknown) << what;
  }
}

TEST(Marks, CannotTellIsRightOnlyWhereNobodyCould) {
  const Answer cannot = answer(Verdict::kCannotTell, {});
  const Truth weak = effect_truth("cohesion", 21);
  EXPECT_TRUE(marked(weak, cannot, 1.99).right);
  EXPECT_FALSE(marked(weak, cannot, 1.99).strictly_right);
  EXPECT_FALSE(marked(weak, cannot, 2.01).right);
  EXPECT_FALSE(marked(weak, answer(Verdict::kNoGap, {"none"}), 0.1).right) << "saying that nothing is wrong is another thing";
}

TEST(Marks, MembersOfAClassAreTheClass) {
  EXPECT_TRUE(marked(effect_truth("load_cell_gain", 0.2), answer(Verdict::kEffect, {"apparatus"})).right);
  EXPECT_TRUE(marked(effect_truth("preparation_gravity", 0.5), answer(Verdict::kEffect, {"preparation"})).right);
  EXPECT_EQ(answer_of(pair_truth()), "cohesion+wall_friction");
}

TEST(Marks, ProbabilitiesAddUpAndKeepAShareOfDoubt) {
  EXPECT_EQ(all_answers().size(), 2U + 12 + 66);
  const Opinion sure = doubting("cohesion", {{"cohesion", 1}});
  const double share = kDoubt / static_cast<double>(all_answers().size());
  EXPECT_DOUBLE_EQ(sure.p.at("cohesion"), 1 - kDoubt + share);
  EXPECT_DOUBLE_EQ(sure.p.at("none"), share);
  double sum = 0;
  for (const auto& [name, p] : sure.p) sum += p;
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(doubting("", {}).p.at("none"), 1.0 / static_cast<double>(all_answers().size()), 1e-12) << "no opinion is an even one";
}

TEST(Marks, ProbabilityOfAClassIsThatOfItsModels) {
  Answer given = answer(Verdict::kEffect, {"apparatus"});
  given.diagnosis.models = {{.model = "seating", .cause = "apparatus", .probability = 0.5, .strength = {}},
                            {.model = "load_cell_gain", .cause = "apparatus", .probability = 0.3, .strength = {}},
                            {.model = "none", .cause = "none", .probability = 0.2, .strength = {}}};
  const Mark m = marked(effect_truth("seating", 0.01), given);
  EXPECT_NEAR(m.ours.p.at("apparatus"), 0.8 * (1 - kDoubt) + kDoubt / 80, 1e-12);
  EXPECT_DOUBLE_EQ(m.declared_confidence, m.ours.p.at("apparatus"));
}

TEST(Marks, StrengthIsThatOfTheTruthsOwnEffect) {
  Answer given = answer(Verdict::kEffect, {"cohesion"});
  given.diagnosis.models = {{.model = "cohesion", .cause = "cohesion", .probability = 1, .strength = {{"cohesion", "Pa", 600, 400, 900}}}};
  const Mark m = marked(effect_truth("cohesion", 500), given);
  ASSERT_TRUE(m.strength.has_value());
  EXPECT_NEAR(m.strength->log_error(), std::log(1.2), 1e-12);
  EXPECT_TRUE(m.strength->covered());
  EXPECT_FALSE(marked(effect_truth("cohesion", 399), given).strength->covered());
  EXPECT_FALSE(marked(effect_truth("breakage", 1), given).strength.has_value()) << "a model that was not weighed has no strength";
  EXPECT_TRUE(std::isinf((StrengthMark{"lateral_stress_offset", "Pa", -300, 200, 100, 300}).log_error())) << "a wrong sign is no small error";
}

TEST(Marks, WhereIsRightWhenTheMovedGroupStandsFirst) {
  Answer given = answer(Verdict::kEffect, {"cohesion"});
  EXPECT_FALSE(marked(effect_truth("cohesion", 500), given).where.has_value());
  given.where = "settle";
  EXPECT_EQ(marked(effect_truth("cohesion", 500), given).where, true);
  given.where = "repose";
  EXPECT_EQ(marked(effect_truth("cohesion", 500), given).where, false);
  EXPECT_FALSE(marked(null_truth(), given).where.has_value());
}

TEST(Answers, TravelAsText) {
  Answer given = answer(Verdict::kOneOf, {"cohesion", "none"});
  given.case_name = "blind-1", given.source = {"bank", "sha", "0.1", 3, "landlock"};
  given.diagnosis.models = {{.model = "cohesion",
                             .cause = "cohesion",
                             .log_z = -3,
                             .log_z_error = 0.1,
                             .probability = 0.6,
                             .strength = {{"cohesion", "Pa", 600, 400, 900}}}};
  given.diagnosis.where = {{.group = {gap::Test::kRepose, 0, Part::kWhole}, .feature = "repose_angle", .text = "high", .p = 0.01}};
  given.baselines = {
      .refits = {{.model = "none", .rms = 2, .bic_probability = 1}}, .lowest_rms = "none", .bic = "none", .nearest_pattern = "cohesion"};
  const auto back = answer_from(answer_text(given));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->diagnosis.verdict, Verdict::kOneOf);
  EXPECT_EQ(back->diagnosis.classes, given.diagnosis.classes);
  EXPECT_EQ(back->diagnosis.models.front().strength.front().high, 900);
  EXPECT_EQ(back->where, "repose");
  EXPECT_EQ(back->baselines.nearest_pattern, "cohesion");
  EXPECT_EQ(back->source.protection, "landlock");
  EXPECT_EQ(answer_from("{}").error().code, Code::kDataLoss);
}

}  // namespace
}  // namespace regolab::gap
