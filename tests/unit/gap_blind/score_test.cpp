/// Figures of hand-made tables whose answers are known in closed form.
#include "scheduler/gap/blind/score.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scheduler/gap/blind/record.h"

namespace regolab::gap {
namespace {

using ::testing::HasSubstr;

constexpr double kAnswers = 80;

/// A mark that gives `p` to `named` and shares the rest evenly, without the share of doubt.
Mark marked(TruthKind kind, const std::string& effect, const std::string& named, double p, double isolability = 5) {
  Truth truth{.id = "c", .kind = kind};
  if (!effect.empty()) truth.effects[effect] = 100;
  if (kind == TruthKind::kUnknown) truth.unknown = "batches";
  Mark m{.truth = truth, .answer = answer_of(truth), .verdict = "EFFECT"};
  m.ours.named = named;
  if (!named.empty()) m.listed = {named};
  for (const std::string& answer : all_answers()) m.ours.p[answer] = answer == named ? p : (1 - p) / (kAnswers - 1);
  m.declared_confidence = p;
  m.right = m.strictly_right = named == m.answer;
  if (!effect.empty()) m.gap = TrueGap{isolability, "settle"};
  for (const char* baseline : {"bic", "lowest_rms", "nearest_pattern"}) m.baselines[baseline] = {"cohesion", m.ours.p};
  return m;
}

const Interval& figure(const Score& score, const std::string& name) { return std::ranges::find(score.figures, name, &Figure::name)->value; }

TEST(Scores, OfOneAnswer) {
  const Mark m = marked(TruthKind::kEffect, "cohesion", "cohesion", 0.7);
  EXPECT_NEAR(log_score(m.ours, "cohesion"), -std::log(0.7), 1e-12);
  EXPECT_NEAR(log_score(m.ours, "none"), -std::log(0.3 / 79), 1e-12);
  EXPECT_NEAR(brier(m.ours, "cohesion"), 0.09 + 0.09 / 79, 1e-12);
  EXPECT_NEAR(brier(m.ours, "none"), 0.49 + (1 - 0.3 / 79) * (1 - 0.3 / 79) + 78 * (0.3 / 79) * (0.3 / 79), 1e-12);
}

TEST(Scores, OfAHandMadeTable) {
  std::vector<Mark> marks{marked(TruthKind::kEffect, "cohesion", "cohesion", 0.9),
                          marked(TruthKind::kEffect, "cohesion", "breakage", 0.6, 3),
                          marked(TruthKind::kEffect, "breakage", "breakage", 0.8),
                          marked(TruthKind::kNull, "", "none", 0.7),
                          marked(TruthKind::kNull, "", "cohesion", 0.5),
                          marked(TruthKind::kUnknown, "", "unknown", 0.9),
                          marked(TruthKind::kUnknown, "", "", 0.2),
                          marked(TruthKind::kNull, "", "none", 0.9)};
  marks.back().truth.extra = true;
  marks[1].listed = {"breakage", "cohesion"}, marks[4].listed = {"cohesion", "none"};
  const Score score = score_of(marks, 2);
  EXPECT_EQ(score.cases, 7);
  EXPECT_EQ(score.extra, 1);
  EXPECT_EQ(score.missing, 2);
  EXPECT_DOUBLE_EQ(figure(score, "top1").value, 4.0 / 7);
  EXPECT_DOUBLE_EQ(figure(score, "listed").value, 6.0 / 7);
  EXPECT_DOUBLE_EQ(figure(score, "false_alarms").value, 1.0 / 3);
  EXPECT_DOUBLE_EQ(figure(score, "false_alarms_sure").value, 0) << "no gap was among it";
  EXPECT_DOUBLE_EQ(figure(score, "top1_strong").value, 1);
  EXPECT_EQ(figure(score, "top1_strong").n, 2);
  EXPECT_DOUBLE_EQ(figure(score, "top1_weak").value, 0);
  EXPECT_DOUBLE_EQ(figure(score, "false_alarms_extra").value, 0);
  EXPECT_DOUBLE_EQ(figure(score, "false_alarms").value, 1.0 / 3);
  EXPECT_DOUBLE_EQ(figure(score, "unknown_detected").value, 0.5);
  EXPECT_DOUBLE_EQ(figure(score, "false_none_of_these").value, 0);
  const double other = std::log(79.0);
  const double sum =
      -std::log(0.9) + (other - std::log(0.4)) - std::log(0.8) - std::log(0.7) + (other - std::log(0.5)) - std::log(0.9) + (other - std::log(0.8));
  EXPECT_NEAR(figure(score, "log_score").value, sum / 7, 1e-12);
  EXPECT_EQ(figure(score, "shrinkage").n, 0) << "what was not measured is not there";
  EXPECT_DOUBLE_EQ(score.effects.at("cohesion").value, 0.5);
  EXPECT_DOUBLE_EQ(score.effects.at("none").value, 0.5);
  EXPECT_DOUBLE_EQ(score.unknowns.at("batches").value, 0.5);
}

TEST(Scores, BaselinesGetTheConfidenceThatSuitsThemBest) {
  std::vector<Mark> marks{marked(TruthKind::kEffect, "cohesion", "cohesion", 0.9), marked(TruthKind::kEffect, "cohesion", "cohesion", 0.9),
                          marked(TruthKind::kEffect, "breakage", "breakage", 0.9), marked(TruthKind::kNull, "", "none", 0.9)};
  const Score score = score_of(marks, 0);
  ASSERT_EQ(score.methods.size(), 5U);
  const MethodScore& rms = score.methods[1];
  EXPECT_EQ(rms.name, "lowest_rms");
  EXPECT_DOUBLE_EQ(rms.top1.value, 0.5) << "it always says cohesion";
  const double sure = 0.5 * (1 - kDoubt) + kDoubt / kAnswers, rest = 0.5 / 79 * (1 - kDoubt) + kDoubt / kAnswers;
  EXPECT_NEAR(rms.log_score.value, 0.5 * (-std::log(sure) - std::log(rest)), 1e-12);
  EXPECT_NEAR(rms.log_score_less_ours.value, rms.log_score.value - score.methods[0].log_score.value, 1e-12);
  const MethodScore& commonest = score.methods[4];
  const double half = 0.5 * (1 - kDoubt) + kDoubt / kAnswers, quarter = 0.25 * (1 - kDoubt) + kDoubt / kAnswers;
  EXPECT_NEAR(commonest.log_score.value, -0.5 * std::log(half) - 0.5 * std::log(quarter), 1e-12);
}

TEST(Scores, OfStrengths) {
  std::vector<Mark> marks;
  for (const double median : {100.0, 110.0, 120.0}) {
    marks.push_back(marked(TruthKind::kEffect, "cohesion", "cohesion", 0.9));
    marks.back().strength = StrengthMark{"cohesion", "Pa", 100, median, 105, 200};
  }
  marks[0].strength->low = 90;
  const Score score = score_of(marks, 0);
  EXPECT_NEAR(figure(score, "strength_log_error").value, std::log(1.1), 1e-12);
  EXPECT_NEAR(figure(score, "strength_coverage").value, 1.0 / 3, 1e-12);
}

TEST(Intervals, AreClopperAndPearsons) {
  const Interval none = share_of(0, 60), all = share_of(10, 10);
  EXPECT_NEAR(none.low, 0, 1e-12);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 1.0 / 60), 1e-9) << "closed form at no hits";
  EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-9);
  EXPECT_EQ(share_of(0, 0).n, 0);
}

TEST(Intervals, OfAMeanFollowItsStandardError) {
  std::vector<double> v;
  for (int k = 0; k < 400; ++k) v.push_back(k % 2);
  const Interval i = bootstrap(400, [&](const std::vector<int>& cases) {
    double sum = 0;
    for (const int k : cases) sum += v[static_cast<std::size_t>(k)];
    return sum / static_cast<double>(cases.size());
  });
  EXPECT_DOUBLE_EQ(i.value, 0.5);
  EXPECT_NEAR(i.high - i.low, 2 * 1.96 * 0.5 / 20, 0.01);
}

TEST(Calibration, IsNothingForAJudgeWhoIsRightAsOftenAsHeSays) {
  std::vector<double> confidence(100, 0.75);
  std::vector<bool> right;
  std::vector<int> cases;
  for (int k = 0; k < 100; ++k) right.push_back(k % 4 != 0), cases.push_back(k);
  EXPECT_NEAR(calibration_error(confidence, right, cases), 0, 1e-12);
  EXPECT_NEAR(calibration_error(std::vector<double>(100, 1.0), right, cases), 0.25, 1e-12);
  const CalibrationFloor floor = calibration_floor(confidence);
  EXPECT_GT(floor.mean, 0.03);
  EXPECT_LT(floor.mean, floor.q95);
  EXPECT_LT(floor.q95, 0.2);
}

TEST(Median, OfAnEvenNumberIsBetweenTheMiddleTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(Record, HasALineForEachCaseAndSaysWhatItIs) {
  std::vector<Mark> marks{marked(TruthKind::kEffect, "cohesion", "cohesion", 0.9), marked(TruthKind::kNull, "", "none", 0.9)};
  marks[0].truth.development = marks[1].truth.development = true;
  marks[1].problem = "no numbers, \"at all\"";
  const Score score = score_of(marks, 1);
  const std::string csv = record_csv(marks);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
  EXPECT_THAT(csv, HasSubstr("\nc,development,main,effect,cohesion,cohesion=100,"));
  EXPECT_THAT(csv, HasSubstr("\"no numbers, \"\"at all\"\"\""));
  EXPECT_THAT(score_text(score), HasSubstr("DEVELOPMENT SET"));
  EXPECT_THAT(score_text(score), HasSubstr("PARTIAL: 1 cases have no answer"));
  const auto json = nlohmann::json::parse(score_json(score));
  EXPECT_EQ(json["development"], true);
  EXPECT_EQ(json["figures"]["top1"]["value"]["value"], 1.0);
  EXPECT_TRUE(json["figures"]["shrinkage"]["value"].is_null());
}

}  // namespace
}  // namespace regolab::gap
