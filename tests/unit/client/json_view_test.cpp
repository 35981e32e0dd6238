#include "client/json_view.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

TEST(JsonView, ResultsCarryDoorUnitsInTheirKeysAndNullWhereNothingIsKnown) {
  Json out = document("results");
  add_results(sample_results(), out);
  const Json back = Json::parse(text_of(out));
  EXPECT_EQ(back["format"], "regolab.results/1");
  EXPECT_EQ(back["rows"][0]["theta_F_deg"], 0.1);
  EXPECT_EQ(back["rows"][1]["N_E"], "mixture");
  EXPECT_DOUBLE_EQ(back["rows"][0]["bulk_density_g_per_cm3"], 1.65);
  EXPECT_TRUE(back["rows"][3]["repose_angle_deg"].is_null());
  EXPECT_EQ(back["rows"][3]["missing"]["repose_angle"], "not settled (40 s of 40 s), \"raise\" the limit");
  EXPECT_EQ(back["responses"][1]["column"], "bulk_density_g_per_cm3");
}

TEST(JsonView, UnknownTimeLeftIsNull) {
  auto status = sample_status();
  EXPECT_EQ(json_of(status)["remaining_s"], 720);
  status.set_remaining_s(-1);
  EXPECT_TRUE(json_of(status)["remaining_s"].is_null());
}

TEST(JsonView, RangeKeepsTheArticlesSymbols) {
  const Json range = json_of(sample_range());
  EXPECT_EQ(range[1]["unit"], "g/cm3");
  EXPECT_EQ(range[1]["factors"][1]["R"], 0.25);
  EXPECT_EQ(range[1]["factors"][1]["levels"][0]["K_sum"], 3.5);
  EXPECT_EQ(range[1]["factors"][0]["fragile"], true);
  auto without = sample_range();
  without.mutable_responses(0)->mutable_factors(0)->clear_p();
  EXPECT_TRUE(json_of(without)[0]["factors"][0]["p"].is_null());
}

TEST(JsonView, StagesShowTheSpecificationAsTheWireHasIt) {
  pb::ExportItem item;
  item.set_point(3);
  item.mutable_spec()->set_kind(pb::STAGE_STRESS);
  item.mutable_spec()->set_confining_stress_pa(2500);
  auto* m = item.mutable_result()->add_measurements();
  m->set_id("repose_angle");
  m->set_unit_si("rad");
  m->set_value_si(1);
  const Json out = json_of(item);
  EXPECT_EQ(out["spec_si"]["confining_stress_pa"], 2500.0);
  EXPECT_EQ(out["spec_si"]["kind"], "STAGE_STRESS");
  EXPECT_NEAR(out["measurements"]["repose_angle_deg"].get<double>(), 57.29577951308232, 1e-12);
}

TEST(JsonView, BytesThatAreNotTextDoNotBreakTheDocument) {
  const Json out =
      json_of(std::vector<Diagnostic>{{.file = "a\xff.yaml", .line = 1, .column = 1, .text = "bad", .source_line = ""}});
  EXPECT_TRUE(Json::accept(text_of(out)));
}

}  // namespace
}  // namespace regolab::client
