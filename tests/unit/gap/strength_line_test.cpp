#include "scheduler/gap/strength_line.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <cmath>

#include "scheduler/gap/observation_file.h"
#include "unit/gap/dev_files.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using testing_support::at;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<double> kLevels = {1250, 2500, 5000, 10000};

std::vector<Feature> strength(double c, double phi_deg, double c_error, double phi_error_deg) {
  return {{.id = "strength_cohesion", .group = {Test::kStress}, .value = c, .standard_error = c_error},
          {.id = "strength_friction_angle", .group = {Test::kStress}, .value = phi_deg * kDegree, .standard_error = phi_error_deg * kDegree}};
}

/// ln(sigma1/sigma3) written out.
double ratio(double c, double phi_deg, double sigma3) {
  const double t = std::tan((45 + phi_deg / 2) * kDegree);
  return std::log((sigma3 * t * t + 2 * c * t) / sigma3);
}

TEST(StrengthLine, WithoutCohesionIsTheRankineRatioAtEveryStress) {
  const auto line = strength_line(strength(0, 30, 100, 1), kLevels, {});
  ASSERT_TRUE(line);
  for (const Feature& end : line->ends) EXPECT_NEAR(std::exp(end.value), 3, 1e-12);
  EXPECT_EQ(line->ends[0].id, "sigma1_ratio_1.25");
  EXPECT_EQ(line->ends[1].id, "sigma1_ratio_10");
}

TEST(StrengthLine, CohesionCountsTheMoreTheLowerTheStress) {  // JSC-1 as the article quotes it: 1 kPa, 45 degrees
  const auto line = strength_line(strength(1000, 45, 100, 1), kLevels, {});
  EXPECT_NEAR(line->ends[0].value, ratio(1000, 45, 1250), 1e-12);
  EXPECT_NEAR(line->ends[1].value, ratio(1000, 45, 10000), 1e-12);
  EXPECT_NEAR(std::exp(line->ends[0].value) * 1250, 1250 * 5.8284271 + 2000 * 2.4142136, 0.01);
}

TEST(StrengthLine, ErrorsAreThoseOfTheTwoNumbersAndGoTogether) {
  const double c_error = 80, phi_error = 0.4, h = 1e-3;
  const auto line = strength_line(strength(700, 38, c_error, phi_error), kLevels, {});
  Eigen::Matrix2d slopes;
  for (int k = 0; k < 2; ++k) {
    const double sigma3 = k == 0 ? 1250 : 10000;
    slopes(k, 0) = (ratio(700 + h, 38, sigma3) - ratio(700 - h, 38, sigma3)) / (2 * h);
    slopes(k, 1) = (ratio(700, 38 + h, sigma3) - ratio(700, 38 - h, sigma3)) / (2 * h);
  }
  const Eigen::Matrix2d covariance = slopes * Eigen::Vector2d(c_error * c_error, phi_error * phi_error).asDiagonal() * slopes.transpose();
  EXPECT_NEAR(line->ends[0].standard_error, std::sqrt(covariance(0, 0)), 1e-7);
  EXPECT_NEAR(line->ends[1].standard_error, std::sqrt(covariance(1, 1)), 1e-7);
  EXPECT_NEAR(line->correlation, covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1)), 1e-6);
}

TEST(StrengthLine, OneUncertainNumberMovesBothEndsAlike) {
  EXPECT_NEAR(strength_line(strength(700, 38, 80, 0), kLevels, {})->correlation, 1, 1e-12);
  EXPECT_EQ(strength_line(strength(700, 38, 0, 0), kLevels, {})->correlation, 0);
}

TEST(StrengthLine, StaysWhereItWasFittedIfTwoLevelsAreThere) {
  const std::vector<double> narrow = {2500, 5000}, far = {50e3, 100e3};
  const auto inside = strength_line(strength(0, 30, 1, 1), kLevels, narrow);
  EXPECT_EQ(inside->ends[0].group.sigma3, 2500);
  EXPECT_EQ(inside->ends[1].group.sigma3, 5000);
  EXPECT_EQ(strength_line(strength(0, 30, 1, 1), kLevels, far)->ends[0].group.sigma3, 1250);
}

TEST(StrengthLine, IsNoneWithoutBothNumbersTwoLevelsOrAPositiveStress) {
  EXPECT_FALSE(strength_line(std::vector{strength(0, 30, 1, 1)[0]}, kLevels, {}));
  EXPECT_FALSE(strength_line(strength(0, 30, 1, 1), std::vector<double>{5000}, {}));
  EXPECT_FALSE(strength_line(strength(-9000, 30, 1, 1), kLevels, {}));
}

const std::string kLine = "observables:\n- {id: cohesion, value: 8, unit: kPa, standard_error: 0.8}\n- {id: friction_angle_internal, value: 37.2, unit: deg, standard_error: 1}\n";

ObservationSet accepted(const std::string& entries) {
  auto out = read_observations("f.yaml", "format: observations/1\ncase: c\n" + entries);
  for (const Diagnostic& d : out.diagnostics) ADD_FAILURE() << to_text(d);
  return out.value.value_or(ObservationSet{});
}

TEST(StrengthLine, IsReadFromAFileAsTwoFeatures) {
  const ObservationSet set = accepted(kLine);
  EXPECT_THAT(set.unused, IsEmpty());
  EXPECT_THAT(set.warnings, Contains(Field(&Diagnostic::text, HasSubstr("nominal_protocol.sigma3_kPa"))));
  const auto features = features_of(readings_of(set));
  EXPECT_THAT(features, ElementsAre(Field(&Feature::id, "strength_cohesion"), Field(&Feature::id, "strength_friction_angle")));
  EXPECT_DOUBLE_EQ(features[0].value, 8000);
  EXPECT_EQ(features[1].group.text(), "stress strength");
  EXPECT_EQ(feature_info("strength_cohesion")->group, features[0].group);
  const auto again = read_observations("n.yaml", observations_yaml(set));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.value->scalars.size(), 2U);
}

TEST(StrengthLine, StandsBackWhereSigma1IsGiven) {
  for (const char* sigma1 : {"- {id: sigma1_at_sigma3_5kPa, value: 20, unit: kPa, standard_error: 1}\n", "- {id: sigma1_peak_at_sigma3_5kPa, value: 20, unit: kPa, standard_error: 1}\n"}) {
    const ObservationSet set = accepted(kLine + sigma1);
    EXPECT_THAT(set.unused, ElementsAre(Field(&Unused::why, HasSubstr("derived")), Field(&Unused::why, HasSubstr("derived"))));
    EXPECT_EQ(set.scalars.size(), 1U);
  }
}

TEST(StrengthLine, TakesBothNumbers) {
  const std::string density = "observables:\n- {id: bulk_density, value: 1.6, unit: g/cm3, standard_error: 0.01}\n";
  const ObservationSet c = accepted(density + "- {id: cohesion, value: 8, unit: kPa, standard_error: 0.8}\n");
  EXPECT_THAT(c.unused, ElementsAre(Field(&Unused::why, HasSubstr("no friction_angle_internal"))));
  const ObservationSet phi = accepted(density + "- {id: friction_angle_internal, value: 37, unit: deg, standard_error: 0.8}\n");
  EXPECT_THAT(phi.unused, ElementsAre(Field(&Unused::why, HasSubstr("no cohesion"))));
}

}  // namespace
}  // namespace regolab::gap
