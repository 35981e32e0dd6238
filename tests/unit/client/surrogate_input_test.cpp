/// Materials and confirmation designs, as the client makes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "client/confirm.h"
#include "client/materials.h"

namespace regolab::client {
namespace {

using ::testing::HasSubstr;

std::string table(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("materials-" + std::to_string(::getpid()) + ".csv");
  std::ofstream(path) << text;
  return path.string();
}

TEST(Materials, SetsAndTablesSayTheSame) {
  pb::PredictRequest by_set, by_table;
  Arguments arguments;
  arguments.set = {"theta_F=40 deg", "K_N=5e4 N/m", "N_E=2"};
  ASSERT_TRUE(read_materials(arguments, by_set).ok());
  Arguments rows;
  rows.set = {"N_E=2"};
  rows.table = table("point,theta_F_deg,K_N_N_per_m,eta_N_N_s_per_m\n1,40,5e4,0.5\n2,20,5e4,0.5\n");
  ASSERT_TRUE(read_materials(rows, by_table).ok());
  ASSERT_EQ(by_table.materials_size(), 2);
  for (const char* name : {"theta_F", "K_N", "N_E"}) EXPECT_EQ(by_table.materials(0).set().at(name), by_set.materials(0).set().at(name)) << name;
  EXPECT_EQ(by_table.materials(1).set().at("eta_N"), "0.5 N s/m");
}

TEST(Materials, BadOnesAreTold) {
  pb::PredictRequest request;
  Arguments arguments;
  for (const auto& [words, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"theta_F"}, "must be NAME=VALUE"}, {{"=3"}, "must be NAME=VALUE"}, {{"a=1", "a=2"}, "stands twice"}}) {
    arguments.set = words;
    const Outcome read = read_materials(arguments, request);
    EXPECT_EQ(read.exit, Exit::kUsage);
    EXPECT_THAT(read.text, HasSubstr(says));
  }
  arguments.set.clear();
  arguments.table = table("theta_F_deg,N_E\n40\n");
  EXPECT_THAT(read_materials(arguments, request).text, HasSubstr(":2: row has 1 cells"));
  arguments.table = table("theta_F_deg,N_E\n");
  EXPECT_THAT(read_materials(arguments, request).text, HasSubstr("holds no material"));
  arguments.table = "/nonexistent.csv";
  EXPECT_EQ(read_materials(arguments, request).exit, Exit::kInvalidInput);
}

TEST(Materials, StressesNeedTheirUnit) {
  Arguments arguments;
  std::vector<double> pascal;
  arguments.sigma3 = {"3kPa", "2500 Pa"};
  ASSERT_TRUE(read_stresses(arguments, pascal).ok());
  EXPECT_EQ(pascal, (std::vector<double>{3000, 2500}));
  for (const char* bad : {"3", "-1 kPa", "3 m", "many"}) {
    arguments.sigma3 = {bad};
    EXPECT_EQ(read_stresses(arguments, pascal).exit, Exit::kUsage) << bad;
  }
}

pb::InvertReply reply() {
  pb::InvertReply out;
  for (const auto& [id, value, tolerance] : {std::tuple{"bulk_density", 1.6, 0.016}, std::tuple{"sigma1_at_sigma3_2.5kPa", 8.0, 0.4}}) {
    auto& t = *out.add_targets();
    t.set_response(id), t.set_value(value), t.set_tolerance(tolerance);
  }
  for (const char* input : {"theta_F", "N_E"}) out.add_freedom()->set_input(input);
  out.add_columns("theta_F_deg"), out.add_columns("N_E");
  for (const char* theta : {"20", "30"}) {
    auto& c = *out.add_candidates();
    (*c.mutable_set())["theta_F"] = std::string(theta) + " deg";
    (*c.mutable_set())["N_E"] = "4";
    (*c.mutable_set())["profile"] = "standard";
    (*c.mutable_set())["particles"] = "1600";
    c.set_design_row(std::string(theta) + ",4");
  }
  return out;
}

std::vector<pb::Candidate> both() { return {reply().candidates(0), reply().candidates(1)}; }

TEST(Confirmation, WhatDiffersIsATableTheRestIsFixed) {
  const auto request = confirmation_design(reply(), both(), {.first = 5, .count = 2}, "invert");
  EXPECT_EQ(request.attachments().at("candidates.csv"), "theta_F_deg\n20\n30\n");
  for (const char* part : {"seeds: [5, 6]", "profile: standard", "particles: 1600", "fixed: {N_E: 4}", "sigma3: [2.5 kPa]", "density, stress]"}) {
    EXPECT_THAT(request.design_yaml(), HasSubstr(part));
  }
  EXPECT_EQ(runs_of_one(reply()), 2U) << "settling and one stress test; no repose was asked for";
}

/// Two rows a seed: density of points 1 and 2, stress of point 1.
pb::ResultsReply measured(std::vector<double> first, std::vector<double> second) {
  pb::ResultsReply results;
  auto& density = *results.add_responses();
  density.set_id("bulk_density"), density.set_unit_si("kg/m3");
  auto& stress = *results.add_responses();
  stress.set_id("sigma1_at_sigma3_2.5kPa"), stress.set_unit_si("Pa");
  for (const int point : {1, 2}) {
    for (const double rho : point == 1 ? first : second) {
      auto& row = *results.add_rows();
      row.set_point(point);
      (*row.mutable_value_si())["bulk_density"] = rho;
      if (point == 1) (*row.mutable_value_si())["sigma1_at_sigma3_2.5kPa"] = 8100 + rho / 1000;
    }
  }
  return results;
}

TEST(Confirmation, MeansAndMissesAreOverTheSeedsThereAre) {
  std::vector<Confirmed> tried;
  learn(reply(), both(), "e", measured({1600, 1620}, {1500}), tried);
  const MeasuredTarget& density = tried[0].targets[0];
  EXPECT_NEAR(density.mean(), 1.61, 1e-12);
  EXPECT_NEAR(density.standard_error(), 0.01, 1e-12);
  EXPECT_NEAR(density.miss(), 0.01 / 0.016, 1e-9);
  EXPECT_TRUE(tried[0].met());
  EXPECT_TRUE(std::isnan(tried[1].targets[1].mean())) << "no stress was measured";
  EXPECT_TRUE(std::isinf(tried[1].miss()));
  EXPECT_EQ(best_of(tried), &tried[0]);
}

TEST(Confirmation, AMeanThatFitsByChanceCollectsMoreBeds) {
  std::vector<Confirmed> tried;
  learn(reply(), both(), "e1", measured({1560, 1645}, {1500, 1501}), tried);
  EXPECT_LE(tried[0].miss(), 1);
  EXPECT_FALSE(tried[0].met()) << "known to 0.04 only, 0.016 was asked for";
  auto next = next_round(tried, reply(), 2);
  ASSERT_EQ(next.size(), 1U) << "the other was run and is surely off, and nothing else is proposed";
  EXPECT_EQ(next[0].design_row(), "20,4");
  learn(reply(), next, "e2", measured({1590, 1600, 1610, 1600, 1595, 1605, 1600, 1600}, {}), tried);
  EXPECT_EQ(tried[0].targets[0].runs.size(), 10U);
  EXPECT_TRUE(tried[0].met());
  EXPECT_EQ(tried[0].experiments, (std::vector<std::string>{"e1", "e2"}));
}

}  // namespace
}  // namespace regolab::client
