#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "digest/sha256.h"
#include "unit/output/fake_stages.h"
#include "vocab/units.h"
#include "worker/output/csv_write.h"
#include "worker/output/number_text.h"
#include "worker/output/observations_write.h"
#include "worker/output/result_json.h"

namespace regolab {
namespace {

using Json = nlohmann::ordered_json;

std::vector<FinishedStage> finished_stages(const Job& job) {
  test::FakeStages fake;
  std::vector<FinishedStage> stages;
  std::string bed;
  for (const StageSpec& spec : stages_of(job)) {
    auto output = fake.run(spec, bed, "", {});
    if (spec.kind == StageKind::kSettle) bed = output->bed;
    stages.push_back({spec, output->result, output->steps, 1.5});
  }
  return stages;
}

TEST(StagesOf, AreSettleFabricReposeThenStressAsListed) {
  std::vector<StageKind> kinds;
  for (const StageSpec& spec : stages_of(test::small_job())) kinds.push_back(spec.kind);
  EXPECT_THAT(kinds, testing::ElementsAre(StageKind::kSettle, StageKind::kFabric, StageKind::kRepose, StageKind::kStress,
                                          StageKind::kStress));
}

TEST(NumberText, ReadsBackAndStaysANumberInYaml) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(yaml_number(1e-05), "1.0e-05");
  EXPECT_EQ(yaml_number(2.5e-12), "2.5e-12");
  EXPECT_EQ(yaml_number(std::numeric_limits<double>::quiet_NaN()), ".nan");
  EXPECT_EQ(shortest_text(shown_value(45.5 * kDegree, 1 / kDegree)), "45.5");
}

TEST(CurveCsv, NamesTheDoorUnitsInItsHeader) {
  const Curve curve{"sigma1_at_sigma3_2.5kPa", "stress", "axial_strain", "1", "sigma1", "Pa", {0, 0.0025}, {2500, 4827.5}};
  EXPECT_EQ(curve_csv(curve), "axial_strain,sigma1_kPa\n0,2.5\n0.0025,4.8275\n");
}

TEST(Observations, HaveEveryKeyOfTheFormatInDoorUnits) {
  const Job job = test::small_job();
  const std::string text = observations_yaml(job, finished_stages(job), "case-1");
  const YAML::Node root = YAML::Load(text);
  EXPECT_EQ(root["format"].as<std::string>(), "observations/1");
  EXPECT_EQ(root["case"].as<std::string>(), "case-1");
  EXPECT_DOUBLE_EQ(root["material"]["nominal_max_size_cm"].as<double>(), 1.0);
  EXPECT_DOUBLE_EQ(root["material"]["nominal_min_size_cm"].as<double>(), 0.2);
  EXPECT_DOUBLE_EQ(root["material"]["particle_density_g_cm3"].as<double>(), 2.93);
  EXPECT_EQ(root["specimen"]["particles"].as<int>(), 300);
  EXPECT_NEAR(root["specimen"]["box_length_cm"].as<double>(), 2.7257, 1e-4);  // 3 (300/400)^(1/3) L_S
  EXPECT_EQ(root["specimen"]["repeats"].as<int>(), 1);
  EXPECT_EQ(root["nominal_protocol"]["sigma3_kPa"].as<std::vector<double>>(), (std::vector<double>{1.25, 2.5}));
  EXPECT_NEAR(root["nominal_protocol"]["stated_strain_rate_1_per_s"][0].as<double>(), 1.0886, 1e-4);  // I sqrt(p/rho)/d
  EXPECT_EQ(text.find("theta"), std::string::npos) << "a diagnosis must not be told";

  const YAML::Node observables = root["observables"];
  ASSERT_EQ(observables.size(), 5u);
  EXPECT_EQ(observables[0]["id"].as<std::string>(), "contacts_per_particle");
  EXPECT_TRUE(observables[0]["standard_error"].IsNull());
  EXPECT_EQ(observables[0]["seeds"].as<int>(), 1);
  EXPECT_NE(text.find("unit: '1'"), std::string::npos) << "a bare 1 would be read as a number";
  EXPECT_EQ(observables[1]["unit"].as<std::string>(), "g/cm3");
  EXPECT_DOUBLE_EQ(observables[1]["value"].as<double>(), 1.416);
  EXPECT_DOUBLE_EQ(observables[2]["value"].as<double>(), 45.5);
  EXPECT_DOUBLE_EQ(observables[2]["standard_error"].as<double>(), 1.5);
  EXPECT_EQ(observables[4]["id"].as<std::string>(), "sigma1_at_sigma3_2.5kPa");
  EXPECT_DOUBLE_EQ(observables[4]["value"].as<double>(), 8.75);

  const YAML::Node stress = root["curves"][3];
  EXPECT_EQ(stress["test"].as<std::string>(), "stress");
  EXPECT_DOUBLE_EQ(stress["sigma3_kPa"].as<double>(), 2.5);
  EXPECT_EQ(stress["x"].size(), stress["y"].size());
  EXPECT_EQ(stress["y_unit"].as<std::string>(), "kPa");
  EXPECT_DOUBLE_EQ(stress["y"][0].as<double>(), 2.5);
}

TEST(Observations, LeaveOutWhatIsNotANumberAndStagesThatDidNotComplete) {
  const Job job = test::small_job();
  auto stages = finished_stages(job);
  stages[1].result.measurements[0].value = std::nan("");
  stages[2].result.end = StageEnd::kOverlap;
  const YAML::Node root = YAML::Load(observations_yaml(job, stages, "x"));
  ASSERT_EQ(root["observables"].size(), 3u);
  EXPECT_EQ(root["observables"][0]["id"].as<std::string>(), "bulk_density");
  EXPECT_EQ(root["observables"][1]["id"].as<std::string>(), "sigma1_at_sigma3_1.25kPa");
}

TEST(ResultJson, HoldsTheResolvedJobAndEveryStage) {
  const Job job = test::small_job();
  auto stages = finished_stages(job);
  stages[3].result.end = StageEnd::kOverlap;
  stages[3].result.reason = "deep (0.3) smaller step";
  const Json json = Json::parse(result_json(job, stages));
  EXPECT_EQ(json["format"], "regolab.result/1");
  EXPECT_EQ(json["end"], "overlap");
  EXPECT_EQ(json["reason"], "deep (0.3) smaller step");
  EXPECT_EQ(json["job"]["micro"]["theta_F"]["value"], 20 * kDegree);
  EXPECT_EQ(json["job"]["micro"]["theta_F"]["shown"], 20.0);
  EXPECT_EQ(json["job"]["micro"]["theta_F"]["shown_unit"], "deg");
  EXPECT_EQ(json["job"]["tests"], Json::array({"settle", "repose", "stress"}));
  ASSERT_EQ(json["stages"].size(), 5u);
  EXPECT_EQ(json["stages"][4]["stage_key"], stage_key(stages[4].spec));
  EXPECT_EQ(json["stages"][4]["measurements"][0]["value"], 8750.0);
  EXPECT_EQ(json["stages"][4]["measurements"][0]["shown"], 8.75);
}

TEST(StageJson, ReadsBackBitForBit) {
  for (const FinishedStage& stage : finished_stages(test::small_job())) {
    const Json json = Json::parse(stage_to_json(stage).dump());
    const auto back = stage_from_json(json, stage.spec);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->result, stage.result);
    EXPECT_EQ(back->steps, stage.steps);
  }
}

TEST(StageJson, WithAMissingKeyIsDataLoss) {
  Json json = stage_to_json(finished_stages(test::small_job())[0]);
  json.erase("numerics");
  EXPECT_EQ(stage_from_json(json, {}).error().code, Code::kDataLoss);
}

}  // namespace
}  // namespace regolab
