#include "input/field.h"

#include <gtest/gtest.h>

#include <set>

#include "input/field_value.h"
#include "support/diagnostics.h"
#include "vocab/units.h"

namespace regolab {
namespace {

TEST(Fields, AreCompleteAndConsistent) {
  std::set<std::string_view> names;
  for (const Field& field : all_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_NE(field.set, nullptr) << field.name;
    EXPECT_TRUE(!field.choices.empty() || field.low < field.high) << field.name;
    EXPECT_FALSE(field.usual.empty()) << field.name;
  }
  EXPECT_EQ(names.size(), 19u + kEffectCount);
}

/// Every field written as its own example or limit is read back, and lands in its own place.
TEST(Fields, TakeTheirLimitsAndRefuseWhatLiesBeyond) {
  for (const Field& field : all_fields()) {
    if (!field.choices.empty()) continue;
    const double factor = door_unit(field.si).factor;
    const std::string unit = field.si == "1" ? "" : " " + std::string(door_unit_of(field));
    const auto read = [&](double si) {
      Report report("f", "");
      const auto value = read_field(field, std::to_string(si * factor) + unit, "", "x", {1, 1}, report);
      EXPECT_EQ(value.has_value(), report.empty());
      return value.has_value();
    };
    EXPECT_TRUE(read(field.high)) << field.name;
    EXPECT_FALSE(read(field.high * 1.01)) << field.name;
    EXPECT_FALSE(read(field.low < 0 ? 1.01 * field.low : -field.high)) << field.name;
    EXPECT_EQ(read(0), field.low <= 0 || field.zero_too) << field.name;
  }
}

TEST(Fields, ShowWhatTheyRead) {
  const Field& angle = *find_field("theta_F");
  EXPECT_EQ(door_text(angle, 0.1 * kDegree), "0.1");
  EXPECT_EQ(door_text(*find_field("L_S"), 0.015), "1.5");
  EXPECT_EQ(door_text(*find_field("N_E"), 12), "mixture");
  EXPECT_EQ(range_text(*find_field("L_S")), "between 0.001 and 100 cm");
  EXPECT_EQ(range_text(*find_field("settle_stiffness_number")), "0 or between 10 and 1000000000");
}

TEST(Fields, TheArticlesWritingOfChoicesIsAccepted) {
  Report report("f", "");
  EXPECT_EQ(read_field(*find_field("N_E"), "12", "", "N_E", {}, report), 12);
  EXPECT_EQ(read_field(*find_field("rotation"), "Non", "", "rotation", {}, report), 0);
  EXPECT_EQ(read_field(*find_field("rotation"), "XZ", "", "rotation", {}, report), 3);
  EXPECT_TRUE(report.empty());
}

TEST(Fields, DampingIsAPureNumberWhenItIsARatio) {
  const Field ratio = under(*find_field("eta_N"), DampingUnit::kRatio);
  Report report("f", "0.3 N s/m\n");
  EXPECT_EQ(read_field(ratio, "0.3", "", "eta_N", {1, 1}, report), 0.3);
  EXPECT_FALSE(read_field(ratio, "0.3 N s/m", "", "eta_N", {1, 1}, report));
  EXPECT_THAT(report.take(),
              ::testing::ElementsAre(testing_support::at(1, 1, "0.3 N s/m is a damping constant, expected a pure number")));
  EXPECT_EQ(under(*find_field("K_N"), DampingUnit::kRatio).si, "N/m");
}

}  // namespace
}  // namespace regolab
