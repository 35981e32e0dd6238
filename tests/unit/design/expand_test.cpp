#include "scheduler/design/expand.h"

#include <gtest/gtest.h>

#include <set>

#include "scheduler/design/design_file.h"
#include "support/diagnostics.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;

Design article() {
  return *read_design(
              {testing_support::read_file(REGOLAB_SOURCE "/client/examples/article-l32.yaml"), "article-l32.yaml", {}},
              {.seeds = 2})
              .value;
}

TEST(Expand, SettlesFirstThenMeasuresOnThatBed) {
  const Design design = article();
  const std::vector<StageSpec> stages = expand(design, design.points[6], 2);
  ASSERT_EQ(stages.size(), 7u);
  EXPECT_EQ(stages[0].kind, StageKind::kSettle);
  EXPECT_EQ(stages[1].kind, StageKind::kFabric);
  EXPECT_EQ(stages[2].kind, StageKind::kRepose);
  for (std::size_t i = 1; i < stages.size(); ++i) EXPECT_EQ(parent_of(stages[i]), stages[0]);
  std::vector<double> stresses;
  for (std::size_t i = 3; i < stages.size(); ++i) stresses.push_back(stages[i].confining_stress);
  EXPECT_THAT(stresses, ElementsAre(1250, 2500, 5000, 10000));
  EXPECT_EQ(stages[0].seed, 2u);
  EXPECT_EQ(stages[0].micro, design.points[6].micro);
}

TEST(Expand, TheWholeStudyIsPointsTimesSeedsTimesStages) {
  const Design design = article();
  EXPECT_EQ(expand(design).size(), 32u * 2u * 7u);
}

TEST(Expand, PointsMayHaveSeedsOfTheirOwn) {
  std::string text = testing_support::read_file(REGOLAB_SOURCE "/client/examples/small-l4.yaml");
  text.replace(text.find("seeds: 2"), 8, "seeds: {first: 1000, each: 2}");
  const auto read = read_design({text, "design.yaml", {}}, {});
  ASSERT_TRUE(read.value) << read.diagnostics.at(0).text;
  EXPECT_THAT(seeds_of(*read.value, read.value->points[0]), ElementsAre(1000, 1001));
  EXPECT_THAT(seeds_of(*read.value, read.value->points[3]), ElementsAre(1006, 1007));
  std::set<std::uint64_t> seeds;
  for (const StageSpec& spec : expand(*read.value)) seeds.insert(spec.seed);
  EXPECT_EQ(seeds.size(), 8u);
  const auto shared = read_design({text, "design.yaml", {}}, {.seeds = 2});
  EXPECT_THAT(seeds_of(*shared.value, shared.value->points[3]), ElementsAre(1, 2)) << "the command line is louder";
}

/// Fixed for all points, as a factor, and as both a bed's and a test's.
TEST(Effects, StandInDesignsAsFixedValuesAndAsFactors) {
  const std::string text = testing_support::read_file(REGOLAB_SOURCE "/client/examples/small-l4.yaml");
  const auto with = [&](const std::string& block, const std::string& levels) {
    std::string changed = text + block;
    changed.insert(changed.find("factors:") + 9, levels);
    return read_design({changed, "design.yaml", {}}, {});
  };
  const auto read = with("\neffects: {frame_compliance: 0.001 1/kPa}\n", "  cohesion: [0 Pa, 200 Pa]\n");
  ASSERT_TRUE(read.value) << read.diagnostics.at(0).text;
  const Design& design = *read.value;
  EXPECT_EQ(design.fixed.at("frame_compliance"), "0.001 1/kPa");
  EXPECT_THAT(design.factors[0].labels, ElementsAre("0", "0.2"));
  EXPECT_EQ(design.factors[0].unit, "kPa");
  for (const DesignPoint& point : design.points) {
    EXPECT_EQ(point.effects[EffectId::kCohesion], point.level[0] == 0 ? 0 : 200);
    for (const StageSpec& spec : expand(design, point, 1)) {
      EXPECT_EQ(spec.effects[EffectId::kCohesion], point.effects[EffectId::kCohesion]) << "acts in every stage";
      EXPECT_EQ(spec.effects[EffectId::kFrameCompliance] != 0, spec.kind == StageKind::kStress);
      if (needs_bed(spec.kind)) {
        EXPECT_EQ(parent_of(spec), expand(design, point, 1)[0]);
      }
    }
  }
  const auto twice = with("\neffects: {cohesion: 100 Pa}\n", "  cohesion: [0 Pa, 200 Pa]\n");
  ASSERT_FALSE(twice.value);
  EXPECT_NE(twice.diagnostics.at(0).text.find("also set outside `factors`"), std::string::npos) << twice.diagnostics.at(0).text;
}

TEST(Responses, PrimaryOnesComeFirstAndKnowTheirStage) {
  const Design design = article();
  const std::vector<TableResponse> responses = responses_of(design);
  std::vector<std::string> first;
  for (std::size_t i = 0; i < 8; ++i) first.push_back(responses[i].id);
  EXPECT_THAT(first,
              ElementsAre("contacts_per_particle", "bulk_density", "void_ratio", "repose_angle", "sigma1_at_sigma3_1.25kPa",
                          "sigma1_at_sigma3_2.5kPa", "sigma1_at_sigma3_5kPa", "sigma1_at_sigma3_10kPa"));
  EXPECT_EQ(source_of("repose_angle_whole").kind, StageKind::kRepose);
  EXPECT_EQ(source_of("core_density").kind, StageKind::kFabric);
  EXPECT_EQ(source_of("void_ratio_compressed_2.5kPa").confining_stress, 2500);
  EXPECT_EQ(source_of("sigma1_0.10_0.20_at_sigma3_10kPa").kind, StageKind::kStress);
  EXPECT_EQ(source_of("sigma1_0.10_0.20_at_sigma3_10kPa").confining_stress, 10000);
  std::set<std::string> ids;
  for (const TableResponse& response : responses) EXPECT_TRUE(ids.insert(response.id).second) << response.id;
}

TEST(Responses, OnlyWhatIsMeasured) {
  Design design = article();
  design.repose = false;
  design.confining_stresses = {3300};
  for (const TableResponse& response : responses_of(design)) EXPECT_EQ(response.id.find("repose"), std::string::npos);
  EXPECT_EQ(responses_of(design)[3].id, "sigma1_at_sigma3_3.3kPa");
}

TEST(Penetration, IsAStagePerPlateOnTheSameBedWithResponsesThatNameThePlate) {
  Design design = article();
  design.plates = {{.width = 0.03, .thickness = 0.003}, {.width = 0.03, .thickness = 0.01}};
  const std::vector<StageSpec> stages = expand(design, design.points[6], 2);
  ASSERT_EQ(stages.size(), stages_per_run(design));
  EXPECT_EQ(stages.back().kind, StageKind::kPenetration);
  EXPECT_EQ(stages.back().plate, design.plates[1]);
  EXPECT_EQ(parent_of(stages.back()), stages[0]);
  EXPECT_EQ(responses_of(design)[9].id, "penetration_force_0.25_0.50_plate_30x10mm");
  for (const char* id : {"penetration_force_0.00_0.25_plate_30x3mm", "penetration_work_plate_30x3mm"}) {
    EXPECT_EQ(source_of(id).kind, StageKind::kPenetration);
    EXPECT_EQ(source_of(id).plate, "30x3mm");
  }
}

TEST(EmptyTable, HasARowPerPointAndSeed) {
  const Design design = article();
  const ResultTable table = empty_table(design, "E1");
  EXPECT_EQ(table.experiment, "E1");
  ASSERT_EQ(table.rows.size(), 64u);
  EXPECT_EQ(table.rows[3].point, 2);
  EXPECT_EQ(table.rows[3].seed, 2u);
  EXPECT_EQ(table.rows[3].level, design.points[1].level);
  EXPECT_TRUE(table.rows[3].value.empty());
  EXPECT_EQ(table.factors[5].name, "L_S");
  EXPECT_EQ(table.factors[5].unit, "cm");
  EXPECT_EQ(table.fixed.at("gravity"), "1.63 m/s2");
}

}  // namespace
}  // namespace regolab
