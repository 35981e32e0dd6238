/// What is handed in of a case: means and errors, the same outside whatever is inside, and nothing of the truth.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "scheduler/gap/blind/draw.h"
#include "scheduler/gap/blind/report_case.h"
#include "scheduler/gap/blind/unknown_kinds.h"
#include "scheduler/gap/observation_file.h"
#include "tests/unit/gap_blind/made_specimens.h"

namespace regolab::gap {
namespace {

using ::testing::HasSubstr;

Truth a_null() {
  Truth t{.id = "9f03ab12cd", .kind = TruthKind::kNull};
  t.material = {.friction_deg = 31.415,
                .normal_stiffness = 51234,
                .normal_damping = 0.51234,
                .tangential_stiffness = 61234,
                .tangential_damping = 0.61234,
                .largest_cm = 1.2,
                .gravity = 1.63,
                .elements = "6",
                .rotation = "xz"};
  t.particles = 288, t.step_fraction = 0.12345, t.seeds = {123456789012, 234567890123}, t.nonce = std::string(64, 'e');
  return t;
}

const Scalar& scalar(const ObservationSet& set, const std::string& id) {
  const auto found = std::ranges::find(set.scalars, id, &Scalar::id);
  if (found == set.scalars.end()) throw std::runtime_error("no " + id);
  return *found;
}

const MeasuredCurve& curve(const ObservationSet& set, const std::string& id) {
  const auto found = std::ranges::find(set.curves, id, &MeasuredCurve::id);
  if (found == set.curves.end()) throw std::runtime_error("no " + id);
  return *found;
}

ObservationSet of(const Truth& truth, std::vector<SpecimenRecord> specimens) {
  for (SpecimenRecord& s : specimens) misrecord(truth, s);
  return observation_of(truth, specimens);
}

ObservationSet of_kind(const std::string& kind, const std::map<std::string, double>& parameters) {
  Truth t = a_null();
  t.kind = TruthKind::kUnknown, t.unknown = kind, t.parameters = parameters;
  return of(t, {made_specimen(), made_specimen()});
}

TEST(Observation, IsTheMeanWithItsStandardError) {
  const ObservationSet set = of(a_null(), {made_specimen(1500), made_specimen(1600), made_specimen(1700)});
  const Scalar& density = scalar(set, "bulk_density");
  EXPECT_DOUBLE_EQ(density.value, 1600);
  EXPECT_NEAR(density.standard_error, 100 / std::sqrt(3.0), 0.05) << "three digits";
  EXPECT_EQ(density.seeds, 3);
  EXPECT_FALSE(density.assumed);
  EXPECT_NEAR(scalar(set, "sigma1_at_sigma3_5kPa").value, kRatio * 5000, 1);
  EXPECT_EQ(std::ranges::count(set.scalars, std::string("settle_private"), &Scalar::id), 0) << "what is no quantity is not handed in";
  const MeasuredCurve& sigma1 = curve(set, "sigma1_at_sigma3_5kPa");
  ASSERT_EQ(sigma1.x.size(), 81U);
  for (std::size_t k = 0; k < 81; ++k) EXPECT_NEAR(sigma1.x[k], 0.0025 * static_cast<double>(k), 1e-9);
  EXPECT_NEAR(sigma1.y[4], 5000 * (1 + 3 * 0.01 / 0.02), 1) << "a straight line between the points of the run";
}

TEST(Observation, WhatAStageDidNotGiveIsAbsentAndOneSpecimenCarriesNoError) {
  auto without = made_specimen(), one = made_specimen();
  without.repose.reset(), without.stress.erase(1250);
  one.stress.erase(1250);
  const ObservationSet set = of(a_null(), {one, without});
  EXPECT_THROW(scalar(set, "E50_at_sigma3_1.25kPa"), std::runtime_error);
  EXPECT_TRUE(scalar(set, "repose_angle").assumed);
  EXPECT_EQ(scalar(set, "repose_angle").seeds, 1);
  EXPECT_FALSE(scalar(set, "bulk_density").assumed);
  EXPECT_THAT(observations_yaml(set), HasSubstr("standard_error: null"));
  EXPECT_TRUE(read_observations("x", observations_yaml(set), MissingErrors::kAssume).ok());
}

TEST(Observation, StrainsAscendWhateverTheApparatusDoesToThem) {
  SpecimenRecord specimen = made_specimen();
  for (auto& [sigma3, result] : specimen.stress) result = *as_measured(result, sigma3, 0.2, {.frame_compliance = 5e-6, .seating = 0.011});
  const ObservationSet set = of(a_null(), {specimen, specimen});
  EXPECT_EQ(curve(set, "sigma1_at_sigma3_10kPa").x, curve(of(a_null(), {made_specimen(), made_specimen()}), "sigma1_at_sigma3_10kPa").x);
  const auto read = read_observations("x", observations_yaml(set));
  for (const Diagnostic& d : read.diagnostics) ADD_FAILURE() << to_text(d);
}

/// Numbers, and the words that differ with them, taken out.
std::string shape_of(const std::string& yaml) { return std::regex_replace(yaml, std::regex("-?[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?"), "0"); }

TEST(Observation, LooksTheSameWhateverIsWrong) {
  const std::string plain = shape_of(observations_yaml(of(a_null(), {made_specimen(1500), made_specimen(1600, 1.02)})));
  for (const UnknownKind& kind : unknown_kinds()) {
    Truth t = a_null();
    t.kind = TruthKind::kUnknown, t.unknown = std::string(kind.name);
    Chance chance(std::string(32, 's'), t.unknown);
    kind.draw(chance, t);
    auto specimens = std::vector{made_specimen(1500), made_specimen(1600, 1.02)};
    for (const BlindPart& part : parts_of(t)) {
      for (const StressLevel& level : part.stress) {
        for (SpecimenRecord& s : specimens) s.stress[level.said] = relabelled(made_stress(level.applied), level.applied, level.said);
      }
    }
    const std::string other = shape_of(observations_yaml(of(t, specimens)));
    EXPECT_EQ(other, plain) << kind.name;
  }
}

TEST(Observation, TellsNothingOfTheTruth) {
  Truth t = a_null();
  t.kind = TruthKind::kEffect, t.effects = {{"cohesion", 812.35}}, t.variants = {{"cohesion_variant", "jkr"}};
  const std::string yaml = observations_yaml(of(t, {made_specimen(), made_specimen()}));
  for (const char* word : {"31.415", "51234", "0.51234", "61234",   "0.61234", "0.12345", "123456789012", "234567890123", "cohesion", "jkr",  "812",
                           "eeee",   "seed:", "effect",  "theta_F", "N_E",     "K_N",     "rotation",     "regolab",      "/",        "quick"}) {
    const std::string told = std::string(word) == "/" ? "/tmp" : word;
    EXPECT_EQ(yaml.find(told), std::string::npos) << told;
  }
  for (const EffectInfo& effect : all_effects()) EXPECT_EQ(yaml.find(effect.name), std::string::npos) << effect.name;
  for (const UnknownKind& kind : unknown_kinds()) EXPECT_EQ(yaml.find(kind.name), std::string::npos) << kind.name;
  std::smatch number;
  for (std::string rest = yaml.substr(yaml.find("curves:")); std::regex_search(rest, number, std::regex("[0-9]+\\.[0-9]+")); rest = number.suffix()) {
    EXPECT_LE(number.str().size(), 8U) << "digits that no instrument has: " << number.str();
  }
}

TEST(Observation, TwinsOfOneTruthSayWhetherTheyAreForDevelopment) {
  Truth t = a_null();
  EXPECT_EQ(of(t, {made_specimen()}).name, "blind-9f03ab12cd");
  t.development = true;
  EXPECT_EQ(of(t, {made_specimen()}).name, "development-9f03ab12cd");
}

TEST(Misrecording, MovesWhatItMovesByWhatItSays) {
  const ObservationSet plain = of(a_null(), {made_specimen(), made_specimen()});
  const double mean_strain = 0.17625;  // of the samples that "0.15 to 0.20" takes
  EXPECT_NEAR(scalar(of_kind("drifting_load_cell", {{"drift_at_0.2_Pa", 2000}}), "sigma1_at_sigma3_1.25kPa").value,
              kRatio * 1250 + 2000 * mean_strain / 0.2, 30);
  EXPECT_NEAR(scalar(of_kind("saturating_load_cell", {{"s_0_Pa", 20000}}), "sigma1_at_sigma3_5kPa").value, 20000 / std::numbers::sqrt2, 10);
  const ObservationSet bottom = of_kind("bottom_cell_gain", {{"gain", 0.4}});
  EXPECT_NEAR(scalar(bottom, "sigma1_at_sigma3_5kPa").value, 1.2 * kRatio * 5000, 5);
  EXPECT_EQ(curve(bottom, "top_plate_stress_at_sigma3_5kPa").y, curve(plain, "top_plate_stress_at_sigma3_5kPa").y);
  const ObservationSet leak = of_kind("leaking_volume_gauge", {{"leak_at_0.2", 0.05}});
  EXPECT_NEAR(curve(leak, "volumetric_strain_contraction_positive_at_sigma3_10kPa").y[40], 0.01 - 0.025, 1e-4);
  EXPECT_EQ(scalar(leak, "sigma1_at_sigma3_10kPa").value, scalar(plain, "sigma1_at_sigma3_10kPa").value);
  const ObservationSet swapped = of_kind("swapped_records", {{"first", 1}});
  EXPECT_NEAR(scalar(swapped, "sigma1_at_sigma3_2.5kPa").value, kRatio * 5000, 5);
  EXPECT_NEAR(scalar(swapped, "sigma1_at_sigma3_5kPa").value, kRatio * 2500, 5);
  EXPECT_NEAR(scalar(swapped, "sigma3_measured_at_sigma3_5kPa").value, 5000, 5);
  EXPECT_EQ(scalar(swapped, "sigma1_at_sigma3_10kPa").value, scalar(plain, "sigma1_at_sigma3_10kPa").value);
  const ObservationSet height = of_kind("misread_height", {{"share", 0.1}});
  EXPECT_NEAR(scalar(height, "bulk_density").value, 1600 / 1.1, 1);
  EXPECT_NEAR(scalar(height, "void_ratio").value, 1.1 * 2930 / 1600 - 1, 1e-3);
  EXPECT_EQ(scalar(height, "core_density").value, scalar(plain, "core_density").value);
}

TEST(Misrecording, AMisscaledTestIsSaidToBeTheOneThatWasMeant) {
  const StageResult said = relabelled(made_stress(7000), 7000, 5000);
  const auto at = [&](const std::string& id) { return std::ranges::find(said.measurements, id, &Measurement::id)->value; };
  EXPECT_NEAR(at("sigma1_at_sigma3_5kPa"), kRatio * 7000, 1e-6);
  EXPECT_NEAR(at("sigma3_measured_at_sigma3_5kPa"), 5000, 1e-6);
  for (const Measurement& m : said.measurements) EXPECT_EQ(m.id.find("7kPa"), std::string::npos) << m.id;
}

}  // namespace
}  // namespace regolab::gap
