#include "scheduler/design/design_file.h"

#include <gtest/gtest.h>

#include "support/diagnostics.h"
#include "vocab/units.h"

namespace regolab {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_support::read_file;

const std::string kFixed =
    "fixed: {theta_F: 20 deg, K_N: 1e5 N/m, eta_N: 0.25 N s/m, K_T: 7.5e4 N/m, eta_T: 1 N s/m, L_S: 1 cm, N_E: 6, rotation: "
    "none}\n";

Design good(const std::string& text, const DesignOverrides& overrides = {},
            const std::map<std::string, std::string>& attachments = {}) {
  const Read<Design> read = read_design({text, "design.yaml", attachments}, overrides);
  EXPECT_THAT(read.diagnostics, IsEmpty());
  return read.value.value_or(Design{});
}

std::string without_fixed(const std::string& name) {
  std::string text = kFixed;
  const std::size_t start = text.find(name + ":");
  const std::size_t end = text.find_first_of(",}", start);
  return text.erase(start, end - start + (text[end] == ',' ? 2 : 0));
}

/// Some cells of Table 2 by eye, one per test quarter, and the restored one; the whole table is compared in tests/article.
TEST(ArticleL32, IsTableTwoRowForRow) {
  const Design design = good(read_file(REGOLAB_SOURCE "/client/examples/article-l32.yaml"));
  ASSERT_EQ(design.points.size(), 32u);
  EXPECT_EQ(design.array, "L32, rows as given (4^8)");
  EXPECT_EQ(design.quality.strength, 2);
  EXPECT_TRUE(design.quality.balanced);
  EXPECT_EQ(design.quality.error_degrees_of_freedom, 7);
  const Micro& five = design.points[4].micro;
  EXPECT_DOUBLE_EQ(five.friction_angle, 20 * kDegree);
  EXPECT_DOUBLE_EQ(five.normal_stiffness, 5e4);
  EXPECT_EQ(five.kind, ParticleKind::kTwo);
  EXPECT_EQ(five.rotation, Rotation::kZ);
  const Micro& last = design.points[31].micro;
  EXPECT_DOUBLE_EQ(last.friction_angle, 60 * kDegree);
  EXPECT_DOUBLE_EQ(last.normal_stiffness, 2.5e4);
  EXPECT_DOUBLE_EQ(last.normal_damping, 1);
  EXPECT_DOUBLE_EQ(last.tangential_stiffness, 1e5);
  EXPECT_DOUBLE_EQ(last.tangential_damping, 0.75);
  EXPECT_DOUBLE_EQ(last.largest_diameter, 0.01);
  EXPECT_EQ(design.points[1].micro.kind, ParticleKind::kMixture);
  EXPECT_EQ(design.points[0].numerics, Numerics{});
  EXPECT_EQ(design.fixed.at("gravity"), "1.63 m/s2");
}

TEST(ArticleL32, IsRefusedWithAnotherStiffnessInTestFive) {
  const std::string text = read_file(REGOLAB_SOURCE "/client/examples/article-l32.yaml");
  const std::string changed =
      testing_support::replaced(text, "[20,  5e4,   0.75, 2.5e4, 0.5,", "[20,  1e5,   0.75, 2.5e4, 0.5,");
  ASSERT_NE(changed, text);
  const Read<Design> read = read_design({changed, "design.yaml", {}}, {});
  ASSERT_EQ(read.diagnostics.size(), 1u);
  EXPECT_THAT(read.diagnostics[0].text,
              HasSubstr("the rows are no L32 (theta_F and K_N do not hold every pair of levels equally often)"));
}

TEST(Examples, TheSmallStudyReads) {
  const Design design = good(read_file(REGOLAB_SOURCE "/client/examples/small-l4.yaml"));
  EXPECT_EQ(design.points.size(), 4u);
  EXPECT_EQ(design.quality.error_degrees_of_freedom, 1);
  EXPECT_THAT(design.seeds, ElementsAre(1, 2));
}

TEST(DesignFile, LevelsWithOwnUnitsOrOneForAll) {
  const Design a = good("factors: {theta_F: [10 deg, 0.5 rad]}\n" + without_fixed("theta_F"));
  EXPECT_DOUBLE_EQ(a.points[1].micro.friction_angle, 0.5);
  EXPECT_EQ(a.factors[0].unit, "deg");
  EXPECT_EQ(a.factors[0].labels[0], "10");
  const Design b = good("factors: {L_S: {unit: mm, levels: [5, 10, 1.5 cm]}}\n" + without_fixed("L_S"));
  EXPECT_THAT(b.factors[0].labels, ElementsAre("0.5", "1", "1.5"));
  EXPECT_DOUBLE_EQ(b.points[2].micro.largest_diameter, 0.015);
}

TEST(DesignFile, AutoIsTheDefaultArray) {
  const Design design = good("factors:\n  theta_F: [10 deg, 20 deg]\n  N_E: [2, 4]\n  gravity: [1.63 m/s2, 9.8 m/s2]\n" +
                             testing_support::replaced(without_fixed("theta_F"), "N_E: 6, ", ""));
  EXPECT_EQ(design.array, "L4 (2^3)");
  EXPECT_THAT(factor_columns(design),
              ElementsAre("theta_F: 2 levels, column 1", "N_E: 2 levels, column 2", "gravity: 2 levels, column 3"));
  EXPECT_DOUBLE_EQ(design.points[0].micro.gravity, 1.63);
  EXPECT_THAT(design.notes, Contains(HasSubstr("no error degree of freedom")));
}

TEST(DesignFile, NumericsCanBeFactors) {
  const Design design = good("factors: {particles: [100, 200], step_fraction: [0.075, 0.15]}\n" + kFixed);
  EXPECT_EQ(design.points[3].numerics.clusters, 200);
  EXPECT_DOUBLE_EQ(design.points[3].numerics.step_fraction, 0.15);
  EXPECT_FALSE(design.fixed.contains("particles"));
}

TEST(DesignFile, OverridesWinOverTheFile) {
  const std::string text =
      "profile: quick\nseeds: [7, 9]\nfactors: {theta_F: [10 deg, 20 deg]}\n" + without_fixed("theta_F");
  EXPECT_THAT(good(text).seeds, ElementsAre(7, 9));
  const Design design = good(text, {.profile = "standard", .seeds = 3});
  EXPECT_EQ(design.profile, "standard");
  EXPECT_EQ(design.points[0].numerics.clusters, 400);
  EXPECT_THAT(design.seeds, ElementsAre(1, 2, 3));
}

TEST(DesignFile, WrongOverridesAreToldWithoutAPlace) {
  const std::string text = "factors: {theta_F: [10 deg, 20 deg]}\n" + without_fixed("theta_F");
  const Read<Design> read = read_design({text, "design.yaml", {}}, {.profile = "quik", .seeds = 5000});
  EXPECT_THAT(read.diagnostics, ElementsAre(testing_support::at(0, 0, "did you mean 'quick'?"),
                                            testing_support::at(0, 0, "--seeds 5000 (at most 1000)")));
}

TEST(DesignFile, RowsOfValues) {
  const Design design = good(
      "factors:\n  theta_F: {unit: deg, levels: [10, 20]}\n  N_E: [2, 6]\narray:\n  rows:\n    - [10, 2]\n    - [20, 2]\n   "
      " - [20, 6]\n" +
      testing_support::replaced(without_fixed("theta_F"), "N_E: 6, ", ""));
  EXPECT_EQ(design.array, "table (2^2)");
  EXPECT_EQ(design.quality.strength, 0);
  EXPECT_THAT(design.points[2].level, ElementsAre(1, 1));
  EXPECT_THAT(design.notes, Contains(HasSubstr("not orthogonal: theta_F and N_E")));
}

TEST(DesignFile, TableBringsItsOwnFactors) {
  const std::string csv = "theta_F_deg,N_E\n10,2\n10,6\n40,2\n40,6\n";
  const Design design =
      good("array: {table: points.csv}\n" + testing_support::replaced(without_fixed("theta_F"), "N_E: 6, ", ""), {},
           {{"points.csv", csv}});
  EXPECT_EQ(design.array, "table (2^2)");
  EXPECT_EQ(design.quality.strength, 2);
  EXPECT_THAT(design.factors[0].labels, ElementsAre("10", "40"));
  EXPECT_EQ(design.points[1].micro.kind, ParticleKind::kSix);
}

TEST(DesignFile, TheBoxFollowsTheParticlesUnlessGiven) {
  const std::string factors = "factors: {L_S: [1 cm, 2 cm]}\n" + without_fixed("L_S");
  EXPECT_EQ(good(factors).points[1].numerics.box_length, 0);
  EXPECT_DOUBLE_EQ(good("box: {length: 10 cm, width: 8 cm}\n" + factors).points[0].numerics.box_length, 0.1);
}

TEST(DesignFile, DampingAsARatio) {
  const Design design =
      good("factors: {eta_N: [0.1, 0.5]}\n" +
           testing_support::replaced(testing_support::replaced(without_fixed("eta_N"), "eta_T: 1 N s/m", "eta_T: 0.3"), "{",
                                     "{damping_unit: ratio, "));
  EXPECT_EQ(design.factors[0].unit, "1");
  EXPECT_EQ(design.points[0].micro.damping_unit, DampingUnit::kRatio);
  EXPECT_EQ(design.fixed.at("damping_unit"), "ratio");
}

}  // namespace
}  // namespace regolab
