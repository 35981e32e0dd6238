#include "scheduler/gap/observation_file.h"

#include <gmock/gmock.h>

#include <cmath>

#include "input/yaml_tree.h"
#include "unit/gap/dev_files.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using testing_support::at;
using testing_support::replaced;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Read<ObservationSet> read(const std::string& text, MissingErrors missing = MissingErrors::kRefuse) { return read_observations("f.yaml", text, missing); }
std::vector<Diagnostic> refused(const std::string& text) { return read(text).diagnostics; }

/// The set, and what is wrong when there is none.
ObservationSet accepted(const std::string& text, MissingErrors missing = MissingErrors::kRefuse) {
  auto out = read(text, missing);
  for (const Diagnostic& d : out.diagnostics) ADD_FAILURE() << to_text(d);
  return out.value.value_or(ObservationSet{});
}

std::string density(const std::string& value = "1.6", const std::string& unit = "g/cm3", const std::string& error = "0.01") {
  return one_observable("bulk_density", value, unit, error);
}

TEST(Observations, OfTheIndependentCodeAreReadInSi) {
  const ObservationSet set = dev_set("dev-01");
  EXPECT_EQ(set.name, "dev-01");
  EXPECT_DOUBLE_EQ(set.material.nominal_max_size.value_or(0), 0.02);
  ASSERT_TRUE(set.material.grain_density);
  EXPECT_DOUBLE_EQ(set.material.grain_density->value, 2930);
  EXPECT_EQ(set.specimen.repeats, 3);
  EXPECT_DOUBLE_EQ(set.protocol.gravity.value_or(0), 1.63);
  EXPECT_THAT(set.sigma3(), ElementsAre(1250, 2500, 5000, 10000));
  EXPECT_THAT(set.protocol.sigma3, ElementsAre(1250, 2500, 5000, 10000));
  EXPECT_THAT(set.scalars, Contains(AllOf(Field(&Scalar::id, "sigma1_at_sigma3_1.25kPa"), Field(&Scalar::value, DoubleNear(4827, 1e-6)), Field(&Scalar::standard_error, DoubleNear(221, 1e-6)))));
  EXPECT_THAT(set.scalars, Contains(AllOf(Field(&Scalar::id, "repose_angle"), Field(&Scalar::value, DoubleNear(45.6 * kDegree, 1e-9)), Field(&Scalar::unit_as_read, "deg"))));
  EXPECT_EQ(set.curves.size(), 21U);
  EXPECT_FALSE(set.assumed);
  EXPECT_FALSE(set.few);
  EXPECT_THAT(set.warnings, IsEmpty());
}

TEST(Observations, ADerivedDuplicateIsLeftOutAndNamed) {
  for (const char* name : kDevFiles) {
    const ObservationSet set = dev_set(name);
    EXPECT_THAT(set.unused, Contains(AllOf(Field(&Unused::id, "void_ratio"), Field(&Unused::why, HasSubstr("density is kept"))))) << name;
    EXPECT_THAT(set.scalars, Not(Contains(Field(&Scalar::id, "void_ratio")))) << name;
  }
}

TEST(Observations, DensityAndVoidRatioThatContradictEachOtherAreSaid) {
  const auto set = accepted(replaced(dev_text("dev-01"), "value: 1.069", "value: 1.6"));
  EXPECT_THAT(set.warnings, ElementsAre(Field(&Diagnostic::text, AllOf(HasSubstr("contradict each other"), HasSubstr("check the grain density")))));
}

TEST(Observations, AVoidRatioAloneIsTheDensityItMeans) {
  const std::string text = one_observable("void_ratio", "0.8", "'1'", "0.01") + "material: {particle_density_g_cm3: 2.70}\n";
  const auto set = accepted(text);
  ASSERT_EQ(set.scalars.size(), 1U);
  EXPECT_EQ(set.scalars[0].id, "bulk_density");
  EXPECT_NEAR(set.scalars[0].value, 1500, 1e-9);
  EXPECT_NEAR(set.scalars[0].standard_error, 1500 * 0.01 / 1.8, 1e-9);
  EXPECT_THAT(refused(one_observable("void_ratio", "0.8", "'1'", "0.01")), ElementsAre(Field(&Diagnostic::text, HasSubstr("nothing to compare"))));
}

TEST(Observations, AMissingErrorIsRefusedOrAssumedAndStamped) {
  EXPECT_THAT(refused(density("1.6", "g/cm3", "null")), ElementsAre(at(4, 3, "--assume-errors")));
  const auto set = accepted(density("1.6", "g/cm3", "null"), MissingErrors::kAssume);
  EXPECT_TRUE(set.assumed);
  EXPECT_TRUE(set.scalars.at(0).assumed);
  EXPECT_NEAR(set.scalars[0].standard_error, 16, 1e-9);  // 1 % of a density
  EXPECT_FALSE(accepted(density(), MissingErrors::kAssume).assumed);
}

TEST(Observations, BadNumbersAreRefusedAtTheirPlace) {
  EXPECT_THAT(refused(density("1.6", "g/cm3", "-0.1")), ElementsAre(at(7, 19, "must not be negative")));
  EXPECT_THAT(refused(density("1.6", "g/cm3", ".nan")), ElementsAre(at(7, 19, "not a finite number")));
  EXPECT_THAT(refused(density(".nan")), ElementsAre(at(5, 10, "not a finite number")));
  EXPECT_THAT(refused(density("-1.6")), ElementsAre(at(5, 10, "check value and unit")));
  EXPECT_THAT(refused(density("1.6 g/cm3")), ElementsAre(at(5, 10, "not a finite number")));
  EXPECT_THAT(refused(density("1600")), ElementsAre(at(5, 10, "check value and unit")));  // kg/m3 under g/cm3
}

TEST(Observations, UnitsAreNeededKnownAndOfTheRightDimension) {
  EXPECT_THAT(refused(density("1.6", "smoot/cm3")), ElementsAre(at(6, 9, "unknown unit")));
  EXPECT_THAT(refused(density("1.6", "kPa")), ElementsAre(at(6, 9, "is a stress")));
  EXPECT_THAT(refused(replaced(density(), "  unit: g/cm3\n", "")), ElementsAre(at(4, 3, "has no unit")));
  EXPECT_NEAR(accepted(density("1600", "kg/m3", "10")).scalars.at(0).value, 1600, 1e-9);
}

TEST(Observations, UnknownIdsAreKeptAsUnused) {
  const auto set = accepted(density() + "- {id: colour, value: 3, unit: kg, standard_error: null}\ncurves:\n- {id: sound, x: [1, 2], y: [1, 2]}\n");
  EXPECT_THAT(set.unused, ElementsAre(Field(&Unused::id, "colour"), Field(&Unused::id, "sound")));
  EXPECT_EQ(set.scalars.size(), 1U);
}

TEST(Observations, OneNumberIsEnoughAndFlaggedAsFew) {
  const auto set = accepted(density());
  EXPECT_TRUE(set.few);
  EXPECT_THAT(set.warnings, Contains(Field(&Diagnostic::text, HasSubstr("only 1 feature"))));
}

TEST(Observations, WhoMeasuredIsKeptOrRefused) {
  const auto of = [](const std::string& source) { return replaced(density(), "case:", "source: " + source + "\ncase:"); };
  EXPECT_EQ(accepted(of("same_code")).source, kSameCode);
  EXPECT_EQ(accepted(of("laboratory")).source, kLaboratory);
  EXPECT_EQ(accepted(density()).source, "");
  EXPECT_THAT(refused(of("us")), ElementsAre(Field(&Diagnostic::text, HasSubstr("known: laboratory, other_code, same_code"))));
  EXPECT_THAT(refused(of("[us]")), testing::SizeIs(1));
}

TEST(Observations, IdsAreBroughtToOneSpelling) {
  const auto set = accepted(one_observable("sigma1_at_sigma3_5.0kPa", "15", "kPa", "1"));
  EXPECT_EQ(set.scalars.at(0).id, "sigma1_at_sigma3_5kPa");
  EXPECT_DOUBLE_EQ(set.scalars[0].sigma3, 5000);
  EXPECT_EQ(accepted(one_observable("sigma1_at_sigma3_5000Pa", "15", "kPa", "1")).scalars.at(0).id, "sigma1_at_sigma3_5kPa");
}

TEST(Observations, RepeatsThatAgreeAreMergedAndThoseThatContradictRefused) {
  const auto again = [](const std::string& value, const std::string& error, int seeds) {
    return density() + "- {id: bulk_density, value: " + value + ", unit: g/cm3, standard_error: " + error + ", seeds: " + std::to_string(seeds) + "}\n";
  };
  EXPECT_THAT(refused(again("1.7", "0.01", 3)), ElementsAre(at(9, 8, "1.7 g/cm3 here, 1.6 g/cm3 in line 4")));
  const auto merged = accepted(again("1.61", "0.02", 1));
  ASSERT_EQ(merged.scalars.size(), 1U);
  EXPECT_NEAR(merged.scalars[0].value, 1602.5, 1e-9);
  EXPECT_NEAR(merged.scalars[0].standard_error, std::hypot(30, 20) / 4, 1e-9);
  EXPECT_EQ(merged.scalars[0].seeds, 4);
  const auto twice = accepted(again("1.6", "0.01", 3));
  EXPECT_EQ(twice.scalars.at(0).seeds, 3) << "the same line twice is one measurement";
  EXPECT_NEAR(twice.scalars[0].standard_error, 10, 1e-9);
}

TEST(Observations, CurvesAreCheckedPointByPoint) {
  const std::string x = "[0, 0.1, 0.2]", y = "[5, 10, 12]", e = "[0.1, 0.1, 0.1]";
  EXPECT_THAT(refused(one_curve(x, "[5, 10]", e)), ElementsAre(at(10, 6, "2 entries of y for 3 of x")));
  EXPECT_THAT(refused(one_curve(x, y, "[0.1]")), ElementsAre(at(11, 21, "y_standard_error")));
  EXPECT_THAT(refused(one_curve("[0, 0.1, 0.1]", y, e)), ElementsAre(at(8, 15, "x must ascend")));
  EXPECT_THAT(refused(one_curve("[0, 10, 20]", y, e)), ElementsAre(at(8, 10, "x_unit: '%'")));
  EXPECT_THAT(refused(one_curve(x, "[5, .nan, 12]", e)), ElementsAre(at(10, 10, "not a finite number")));
  EXPECT_THAT(refused(one_curve(x, y, "[0.1, -0.1, 0.1]")), ElementsAre(at(11, 27, "must not be negative")));
  EXPECT_THAT(refused(one_curve(x, y, "null")), ElementsAre(at(4, 3, "no standard error")));
  EXPECT_THAT(refused(replaced(one_curve(x, y, e), "sigma3_kPa: 5", "sigma3_kPa: 6")), ElementsAre(at(6, 15, "one of them is wrong")));
}

TEST(Observations, WhatIsMeasuredOfTheMaterialHasItsUnitInTheKey) {
  const auto set = accepted(density() + "material: {theta_F_deg: 30, theta_F_deg_standard_error: 2, K_N_N_per_m: 5e4, N_E: mixture, supplier: x}\n");
  EXPECT_NEAR(set.material.micro.at("theta_F").value, 30 * kDegree, 1e-12);
  EXPECT_NEAR(set.material.micro.at("theta_F").standard_error.value_or(0), 2 * kDegree, 1e-12);
  EXPECT_EQ(set.material.micro.at("K_N").value, 5e4);
  EXPECT_EQ(set.material.micro.at("N_E").value, 12);
  EXPECT_THAT(set.unused, ElementsAre(Field(&Unused::id, "material.supplier")));
  EXPECT_THAT(refused(density() + "material: {theta_F_kPa: 30}\n"), ElementsAre(at(9, 25, "is a stress")));
  EXPECT_THAT(refused(density() + "material: {theta_F_deg: 30, theta_F_rad: 0.5}\n"), ElementsAre(at(9, 29, "already given")));
}

TEST(Observations, AllProblemsAreToldAtOnce) {
  const auto problems = refused(replaced(replaced(replaced(dev_text("dev-01"), "value: 1.416", "value: nan"), "unit: g/cm3", "unit: kPa"), "standard_error: 1.52", "standard_error: -1"));
  EXPECT_EQ(problems.size(), 3U);
}

TEST(Observations, OtherFormatsAndHostileFilesAreRefused) {
  EXPECT_THAT(refused(replaced(density(), "observations/1", "observations/2")), ElementsAre(at(1, 9, "observations/1")));
  EXPECT_THAT(refused(""), ElementsAre(Field(&Diagnostic::text, HasSubstr("empty file"))));
  EXPECT_THAT(refused("\xFF\xFE"), ElementsAre(Field(&Diagnostic::text, HasSubstr("not a text file"))));
  EXPECT_THAT(refused(std::string((16 << 20) + 1, ' ')), ElementsAre(Field(&Diagnostic::text, HasSubstr("16777216"))));
  EXPECT_THAT(refused(density() + "extra: " + std::string(100, '[') + std::string(100, ']') + "\n"), Contains(Field(&Diagnostic::text, HasSubstr("deep"))));
  EXPECT_THAT(refused("a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n"), ElementsAre(at(1, 4, "alias")));  // one message, however large the bomb
  EXPECT_THAT(refused(replaced(density(), "small", std::string("sm\0ll", 5))), ElementsAre(at(2, 9, "byte 0x00")));
  EXPECT_THAT(refused(replaced(density(), "small", "sm\xE4ll")), ElementsAre(at(2, 9, "not a text file")));
  EXPECT_THAT(refused(replaced(density(), "  value: 1.6", "  value: 1.6\n  value: 1.7")), ElementsAre(at(6, 3, "duplicate key 'value'")));
}

TEST(Observations, WindowsLineEndsAndABlankAfterAUnitAreNoMatter) {
  std::string text = density("1.6", "'g/cm3 '");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  EXPECT_DOUBLE_EQ(accepted(text).scalars.at(0).value, 1600);
}

TEST(Observations, AFileOfMoreNumbersThanAnyTestHasIsRefusedInBoundedTime) {
  std::string list = "[1";
  while (list.size() < (4 << 20)) list += ",1,1,1,1,1,1,1,1";
  EXPECT_THAT(refused(one_curve(list + "]", "[1, 2]", "[1, 1]")), Contains(Field(&Diagnostic::text, HasSubstr("1048576 values"))));
  std::string keys = "format: observations/1\ncase: x\nmaterial:\n";
  for (int i = 0; i < 50000; ++i) keys += "  k" + std::to_string(i) + ": 1\n";
  EXPECT_THAT(refused(keys), Contains(Field(&Diagnostic::text, HasSubstr("10000 keys"))));
}

TEST(Observations, WrittenInNormalFormAreReadAsTheSame) {
  for (const char* name : kDevFiles) {
    const ObservationSet first = dev_set(name), again = accepted(observations_yaml(first));
    ASSERT_EQ(first.scalars.size(), again.scalars.size());
    ASSERT_EQ(first.curves.size(), again.curves.size());
    EXPECT_EQ(first.material.size_law, again.material.size_law);
    EXPECT_THAT(again.unused, IsEmpty());
    for (std::size_t i = 0; i < first.scalars.size(); ++i) {
      EXPECT_EQ(first.scalars[i].id, again.scalars[i].id);
      EXPECT_NEAR(first.scalars[i].value, again.scalars[i].value, 1e-10 * std::abs(first.scalars[i].value));
      EXPECT_NEAR(first.scalars[i].standard_error, again.scalars[i].standard_error, 1e-10 * first.scalars[i].standard_error);
    }
  }
}

}  // namespace
}  // namespace regolab::gap
