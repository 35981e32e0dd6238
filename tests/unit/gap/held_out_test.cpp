/// What a fit for confirmation does not see.
#include "scheduler/gap/held_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "unit/gap/dev_files.h"

namespace regolab::gap {
namespace {

Feature stress(double sigma3, const std::string& id, double value) {
  return {.id = id, .group = {Test::kStress, sigma3, Part::kResidual}, .value = value, .standard_error = 0.05, .repeats = 3, .assumed = false};
}

std::vector<Feature> four_levels(double value) {
  std::vector<Feature> out{{.id = "bulk_density", .group = {}, .value = 1600, .standard_error = 8, .repeats = 3, .assumed = false}};
  for (const double sigma3 : {1250.0, 2500.0, 5000.0, 10000.0}) {
    out.push_back(stress(sigma3, "sigma1_ratio_" + std::to_string(sigma3), value));
    out.push_back(stress(sigma3, "E50_ratio_" + std::to_string(sigma3), value));
  }
  return out;
}

TEST(HeldOut, IsOneOfEachTwoStresses) {
  std::set<std::vector<double>> choices;
  for (int k = 0; k < 40; ++k) {
    const auto held = held_out_sigma3(four_levels(1 + 0.01 * k));
    ASSERT_TRUE(held.ok()) << held.error().text;
    ASSERT_EQ(held->size(), 2U);
    EXPECT_TRUE(held->at(0) == 1250 || held->at(0) == 2500);
    EXPECT_TRUE(held->at(1) == 5000 || held->at(1) == 10000);
    choices.insert(*held);
  }
  EXPECT_EQ(choices.size(), 4U) << "what is measured decides, and every choice is met";
}

TEST(HeldOut, IsAFunctionOfTheMeasurementsAlone) {
  const auto features = four_levels(1.7);
  auto shuffled = features;
  std::ranges::reverse(shuffled);
  EXPECT_EQ(*held_out_sigma3(features), *held_out_sigma3(shuffled));
  ObservationSet set = dev_set("dev-02"), renamed = set;
  renamed.name = "another name";
  EXPECT_EQ(*held_out_sigma3(features_of(readings_of(set))), *held_out_sigma3(features_of(readings_of(renamed))));
}

TEST(HeldOut, LeavesAnOddStressInTheFit) {
  std::vector<Feature> features = four_levels(1.7);
  std::erase_if(features, [](const Feature& f) { return f.group.sigma3 == 10000; });
  const auto held = held_out_sigma3(features);
  ASSERT_TRUE(held.ok());
  ASSERT_EQ(held->size(), 1U);
  EXPECT_LT(held->front(), 5000);
}

TEST(HeldOut, RefusesWhereTheFitWouldBeCrippled) {
  std::vector<Feature> one = four_levels(1.7);
  std::erase_if(one, [](const Feature& f) { return f.group.sigma3 > 1250; });
  EXPECT_NE(held_out_sigma3(one).error().text.find("stress tests at one confining stress only"), std::string::npos);
  const std::vector<Feature> few{stress(1250, "a", 1), stress(2500, "b", 1)};
  EXPECT_NE(held_out_sigma3(few).error().text.find("1 features would be left"), std::string::npos);
}

TEST(HeldOut, TakesAwayEveryNumberOfThatStressAndNothingElse) {
  const ObservationSet set = dev_set("dev-01"), kept = without(set, std::vector<double>{2500, 10000});
  const auto before = features_of(readings_of(set)), after = features_of(readings_of(kept));
  std::size_t gone = 0;
  for (const Feature& f : before) gone += f.group.sigma3 == 2500 || f.group.sigma3 == 10000 ? 1 : 0;
  EXPECT_GT(gone, 10U);
  EXPECT_EQ(after.size() + gone, before.size());
  for (const Feature& f : after) EXPECT_TRUE(f.group.sigma3 != 2500 && f.group.sigma3 != 10000) << f.id;
}

}  // namespace
}  // namespace regolab::gap
