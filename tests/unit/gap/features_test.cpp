#include "scheduler/gap/features.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <set>

#include "scheduler/gap/curve_mean.h"
#include "scheduler/gap/quantities.h"
#include "unit/gap/dev_files.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Feature find(const std::vector<Feature>& features, const std::string& id) {
  for (const Feature& f : features) {
    if (f.id == id) return f;
  }
  ADD_FAILURE() << "no feature " << id;
  return {};
}

Readings without_scalar(Readings readings, const std::string& id) {
  EXPECT_EQ(readings.scalars.erase(id), 1U) << id;
  return readings;
}

/// A run of ours: sigma1 = 3 sigma3 and a volume change proportional to strain.
StageResult stress_run(double sigma3) {
  StageResult run;
  const std::string at = "_at_sigma3_" + kilopascals(sigma3) + "kPa";
  run.measurements = {{"sigma1" + at, 3 * sigma3, "Pa", 0.2 * sigma3, ""}, {"sigma1_peak" + at, 4 * sigma3, "Pa", {}, ""}};
  Curve sigma1{"sigma1" + at, "stress", "axial_strain", "1", "sigma1", "Pa", {}, {}}, volume{"volumetric_strain_contraction_positive" + at, "stress", "axial_strain", "1", "v", "1", {}, {}};
  for (int k = 0; k <= 40; ++k) {
    for (Curve* c : {&sigma1, &volume}) c->x.push_back(0.005 * k);
    sigma1.y.push_back(3 * sigma3), volume.y.push_back(-0.5 * 0.005 * k);
  }
  run.curves = {sigma1, volume};
  return run;
}

TEST(Features, OfTheIndependentCodeAgreeBetweenItsNumbersAndItsCurves) {
  int compared = 0;
  for (const char* name : kDevFiles) {
    const Readings readings = readings_of(dev_set(name));
    for (const double sigma3 : sigma3_of(readings)) {
      for (const auto& [scalar, feature] : {std::pair{"sigma1_at_sigma3_", "sigma1_ratio_"}, {"sigma3_measured_at_sigma3_", "sigma3_measured_ratio_"}}) {
        const std::string x = kilopascals(sigma3);
        const Feature number = find(features_of(readings), feature + x), curve = find(features_of(without_scalar(readings, scalar + x + "kPa")), feature + x);
        EXPECT_NEAR(number.value, curve.value, 0.35 * number.standard_error + 0.004) << name << " " << number.id;
        // fully correlated along the curve: an upper limit, which rounded digits may miss by little
        EXPECT_GT(curve.standard_error, 0.8 * number.standard_error) << name << " " << number.id;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 40);
}

TEST(Features, TheWedgeOfAProfileIsThatOfItsMeanHeight) {
  for (const char* name : kDevFiles) {
    const ObservationSet set = dev_set(name);
    const Readings readings = readings_of(set);
    const auto& profile = readings.curves.at("repose_profile");
    const double mean = std::accumulate(profile.y.begin(), profile.y.end(), 0.0) / static_cast<double>(profile.y.size());
    EXPECT_NEAR(find(features_of(readings), "repose_wedge").value, std::atan(2 * mean / *set.specimen.box_length), 2e-4) << name;
  }
}

TEST(Features, AllStandInTheTableAndComeBackById) {
  for (const char* name : kDevFiles) {
    const Readings readings = readings_of(dev_set(name));
    std::set<std::string> known;
    for (const FeatureInfo& info : all_features(sigma3_of(readings))) {
      EXPECT_TRUE(known.insert(info.id).second) << info.id;
      const auto again = feature_info(info.id);
      ASSERT_TRUE(again) << info.id;
      EXPECT_EQ(again->group, info.group) << info.id;
      EXPECT_EQ(again->scale, info.scale) << info.id;
    }
    for (const Feature& f : features_of(readings)) {
      EXPECT_TRUE(known.contains(f.id)) << f.id;
      EXPECT_GT(f.standard_error, 0) << name << " " << f.id;
      EXPECT_EQ(f.repeats, 3) << f.id;
    }
  }
  EXPECT_FALSE(feature_info("sigma1_ratio_"));
  EXPECT_FALSE(feature_info("sigma1_ratio_x"));
  EXPECT_FALSE(feature_info("void_ratio"));
}

TEST(Features, NeverCountDensityAndVoidRatioBoth) {
  for (const Feature& f : features_of(readings_of(dev_set("dev-01")))) EXPECT_NE(f.id, "void_ratio");
}

TEST(Features, OfOurRunsCarryNoErrorOfTheirOwn) {
  Readings readings;
  add_readings(stress_run(2500), readings);
  const auto features = features_of(readings);
  for (const Feature& f : features) EXPECT_EQ(f.standard_error, 0) << f.id;
  EXPECT_NEAR(find(features, "sigma1_ratio_2.5").value, std::log(3), 1e-12);
  EXPECT_NEAR(find(features, "sigma1_early_2.5").value, std::log(3), 1e-12);
  EXPECT_NEAR(find(features, "sigma1_peak_ratio_2.5").value, std::log(4), 1e-12);
  EXPECT_NEAR(find(features, "volumetric_strain_0.05_2.5").value, -0.025, 1e-12);
  EXPECT_NEAR(find(features, "volumetric_strain_0.19_2.5").value, -0.095, 1e-12);
}

TEST(Features, AnUnphysicalRunGivesNone) {
  StageResult run = stress_run(2500);
  run.end = StageEnd::kOverlap;
  Readings readings;
  add_readings(run, readings);
  EXPECT_THAT(features_of(readings), IsEmpty());
}

TEST(Features, ATestThatWentOnHasItsResidualFromTheCurve) {
  StageResult run = stress_run(2500);
  for (int k = 41; k <= 60; ++k) run.curves[0].x.push_back(0.005 * k), run.curves[0].y.push_back(2500 * 9);
  run.measurements[0].value = 2500 * 9;  // over 0.25 to 0.30
  Readings readings;
  add_readings(run, readings);
  EXPECT_NEAR(find(features_of(readings), "sigma1_ratio_2.5").value, std::log(3), 1e-3);
}

TEST(Features, ErrorsAreCarriedThroughLogarithmsAndMeans) {
  Readings readings;
  readings.scalars["sigma1_peak_at_sigma3_5kPa"] = {.value = 20000, .standard_error = 1000, .repeats = 4};
  readings.curves["sigma1_at_sigma3_5kPa"] = {.x = {0, 0.02, 0.04}, .y = {5000, 10000, 20000}, .y_standard_error = {100, 300, 500}, .repeats = 2};
  const auto features = features_of(readings);
  EXPECT_NEAR(find(features, "sigma1_peak_ratio_5").standard_error, 0.05, 1e-12);
  const Feature rising = find(features, "sigma1_rising_5");
  EXPECT_NEAR(rising.value, std::log(3), 1e-12);
  EXPECT_NEAR(rising.standard_error, 400.0 / 15000, 1e-12);
  EXPECT_EQ(rising.repeats, 2);
  EXPECT_EQ(features.size(), 2U) << "what a curve does not reach over is absent";
}

TEST(Features, AShareOfNoneIsNotKnownExactly) {
  const Feature stood = find(features_of(readings_of(dev_set("dev-01"))), "repose_column_stood");
  EXPECT_EQ(stood.value, 0);
  EXPECT_NEAR(stood.standard_error, std::sqrt(0.2 * 0.8 / 3), 1e-12);
}

TEST(Features, ALineAlongABedThatStoodIsNoSlope) {
  Readings readings;
  readings.scalars["repose_angle_whole"] = {.value = -0.05, .standard_error = 0.02};
  readings.scalars["repose_column_stood"] = {.value = 0, .standard_error = 0.1};
  EXPECT_EQ(find(features_of(readings), "repose_angle_whole").value, -0.05);
  readings.scalars["repose_column_stood"].value = 1.0 / 3;
  for (const Feature& f : features_of(readings)) EXPECT_NE(f.id, "repose_angle_whole");
}

TEST(Features, PlatesThatDifferShowItInTheirRatio) {
  Readings readings;
  CurveReading top{.x = {}, .y = {}, .y_standard_error = {}}, bottom = top;
  for (int k = 0; k <= 40; ++k) {
    top.x.push_back(0.005 * k), bottom.x.push_back(0.005 * k);
    top.y.push_back(11000), bottom.y.push_back(9000);
    top.y_standard_error.push_back(550), bottom.y_standard_error.push_back(450);
  }
  readings.curves = {{"top_plate_stress_at_sigma3_5kPa", top}, {"bottom_plate_stress_at_sigma3_5kPa", bottom}};
  const Feature f = find(features_of(readings), "plate_difference_5");
  EXPECT_NEAR(f.value, 0.1, 1e-12);
  EXPECT_LT(f.standard_error, 1e-6) << "both scatter alike, and the ratio does not";
}

TEST(Features, PenetrationIsReadAtDepthsInPlateWidths) {
  Readings readings;
  CurveReading force{.x = {}, .y = {}, .y_standard_error = {}};
  for (int k = 0; k <= 60; ++k) force.x.push_back(0.001 * k), force.y.push_back(2.0 * k);
  readings.curves["penetration_force_plate_30x3mm"] = force;
  const auto features = features_of(readings);
  EXPECT_THAT(features.size(), 3U);
  EXPECT_NEAR(find(features, "penetration_1.0w_30x3mm").value, std::log(60), 1e-9);
}

TEST(FeatureInfo, SaysDifferencesInPhysicalQuantities) {
  EXPECT_EQ(feature_info("sigma1_ratio_1.25")->difference(std::log(3 * 0.62), std::log(3)), "sigma1 at 15 to 20 % strain at 1.25 kPa is 38 % low");
  EXPECT_EQ(feature_info("repose_angle")->difference(43.1 * kDegree, 40 * kDegree), "repose angle is 3.1 deg high");
  EXPECT_EQ(feature_info("bulk_density")->difference(1500, 1600), "bulk density is 6.2 % low");
  EXPECT_NEAR(feature_info("sigma1_ratio_1.25")->physical(std::log(4)), 5000, 1e-9);
  EXPECT_NEAR(feature_info("sigma1_ratio_1.25")->physical_error(std::log(4), 0.1), 500, 1e-9);
  EXPECT_EQ((Group{gap::Test::kStress, 1250, Part::kResidual}).text(), "stress 1.25 kPa residual");
}

}  // namespace
}  // namespace regolab::gap
