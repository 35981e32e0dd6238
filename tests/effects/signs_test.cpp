/// What each effect does to a specimen, in sign, beyond the scatter of seeds: paired runs of 100 clusters, the same seeds with and without.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "vocab/canonical.h"
#include "vocab/units.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

constexpr int kSeeds = 4;

struct Observable {
  StageKind kind;
  std::string id;  ///< of a measurement, or of numerics
  double sigma3 = 0;
  double stiffness_number = 500;  ///< of the stress test
};

StageSpec stage(const Observable& what, std::uint64_t seed, const EffectSet& effects) {
  StageSpec spec{.kind = what.kind, .seed = seed, .effects = effects};
  spec.micro = {.friction_angle = 25 * kDegree,
                .normal_stiffness = 5e4,
                .normal_damping = 0.5,
                .tangential_stiffness = 5e4,
                .tangential_damping = 0.5,
                .largest_diameter = 0.01,
                .kind = ParticleKind::kTwo,
                .rotation = Rotation::kXZ};
  spec.numerics.clusters = 100;
  spec.numerics.stress_stiffness_number = what.stiffness_number;
  spec.numerics.inertial_number = 2e-2;
  spec.numerics.axial_strain = 0.12;
  spec.confining_stress = what.sigma3;
  return spec;
}

/// Each stage once: the base model's runs serve all effects.
const StageOutput& output_of(const StageSpec& spec) {
  static std::map<std::string, StageOutput> done;
  const std::string key = canonical_text(spec);
  if (const auto found = done.find(key); found != done.end()) return found->second;
  const std::string bed = needs_bed(spec.kind) ? output_of(parent_of(spec)).bed : "";
  auto output = run_stage(spec, bed, "", {});
  EXPECT_TRUE(output.ok()) << output.error().text;
  EXPECT_EQ(output->result.end, StageEnd::kCompleted) << output->result.reason;
  return done[key] = std::move(*output);
}

double value_of(const Observable& what, std::uint64_t seed, const EffectSet& effects) {
  const StageResult& result = output_of(stage(what, seed, effects)).result;
  for (const auto* list : {&result.measurements, &result.numerics}) {
    for (const Measurement& m : *list) {
      if (m.id == what.id) return m.value;
    }
  }
  ADD_FAILURE() << what.id << " is not measured";
  return 0;
}

struct Shift {
  double mean, standard_error;
  double over_scatter() const { return mean / standard_error; }
};

Shift shift(const Observable& what, const EffectSet& effects) {
  double sum = 0, squares = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const double with = value_of(what, static_cast<std::uint64_t>(seed), effects), without = value_of(what, static_cast<std::uint64_t>(seed), {});
    sum += with - without, squares += (with - without) * (with - without);
  }
  const double mean = sum / kSeeds, variance = std::max(0.0, squares / kSeeds - mean * mean) / (kSeeds - 1);
  testing::Test::RecordProperty(what.id, std::to_string(mean) + " +- " + std::to_string(std::sqrt(variance)));
  return {mean, std::sqrt(variance)};
}

EffectSet only(EffectId id, double strength) {
  EffectSet effects;
  effects[id] = strength;
  return effects;
}

constexpr double kBeyond = 2;  // standard errors of the mean paired difference
const Observable kDensity{StageKind::kFabric, "bulk_density"}, kWedge{StageKind::kRepose, "repose_angle_wedge"};
Observable sigma1(double kpa) { return {StageKind::kStress, "sigma1_at_sigma3_" + std::string(kpa == 5 ? "5" : "1.25") + "kPa", 1000 * kpa}; }
const Observable kModulus{StageKind::kStress, "E50_at_sigma3_1.25kPa", 1250};

void expect_up(const Observable& what, const EffectSet& effects) {
  const Shift s = shift(what, effects);
  EXPECT_GT(s.over_scatter(), kBeyond) << what.id << " by " << s.mean << " +- " << s.standard_error << " under " << effects_text(effects);
}
void expect_down(const Observable& what, const EffectSet& effects) {
  const Shift s = shift(what, effects);
  EXPECT_LT(s.over_scatter(), -kBeyond) << what.id << " by " << s.mean << " +- " << s.standard_error << " under " << effects_text(effects);
}

TEST(RollingResistance, LoosensTheBedAndStrengthensIt) {
  const EffectSet on = only(EffectId::kRollingResistance, 0.5);
  expect_down(kDensity, on);
  expect_up(sigma1(1.25), on);
  EffectSet other = on;
  other[EffectId::kRollingVariant] = 1;
  expect_down(kDensity, other);
}

TEST(Cohesion, LoosensTheBedAndStrengthensItMostAtLowStress) {
  const EffectSet on = only(EffectId::kCohesion, 1000);
  expect_down(kDensity, on);
  expect_up(kWedge, on);
  expect_up(sigma1(1.25), only(EffectId::kCohesion, 5000));
  EffectSet other = on;
  other[EffectId::kCohesionVariant] = 1;
  expect_down(kDensity, other);
}

/// Springs so soft that the specimen is squeezed by their overlaps more than by rearrangement: matched at 5 kPa.
TEST(HertzianContact, GivesMoreThanTheLinearSpringBelowItsMatchAndLessAbove) {
  const EffectSet on = only(EffectId::kHertzianContact, 1);
  expect_down({StageKind::kStress, "void_ratio_compressed_1.25kPa", 1250, 20}, on);
  expect_up({StageKind::kStress, "void_ratio_compressed_10kPa", 10000, 20}, on);
}

TEST(WallFriction, HoldsTheSpecimenBack) { expect_up(sigma1(1.25), only(EffectId::kWallFriction, 0.6)); }

TEST(SizeDistribution, LeavesFewerNeighboursToFinerGrains) {
  expect_down({StageKind::kFabric, "contacts_per_particle"}, only(EffectId::kSizeDistribution, 1));
}

TEST(BoundaryCompliance, SoftensTheStart) { expect_down(kModulus, only(EffectId::kBoundaryCompliance, 19)); }

TEST(LateralStressOffset, StrengthensBySeveralTimesItselfAndIsNotMeasured) {
  const EffectSet on = only(EffectId::kLateralStressOffset, 1000);
  const Shift s = shift(sigma1(1.25), on);
  EXPECT_GT(s.mean - kBeyond * s.standard_error, 1000);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_NEAR(value_of({StageKind::kStress, "sigma3_measured_at_sigma3_1.25kPa", 1250}, seed, on) / 1250, 1, 0.25);
  }
}

TEST(LoadingRate, IsMultipliedAndStrengthens) {
  const EffectSet on = only(EffectId::kLoadingRate, 1);
  const Observable rate{StageKind::kStress, "strain_rate", 1250};
  EXPECT_NEAR(value_of(rate, 1, on) / value_of(rate, 1, {}), 10, 1e-9);
  expect_up(sigma1(1.25), on);
}

TEST(PreparationFriction, DensifiesTheBed) { expect_up(kDensity, only(EffectId::kPreparationFriction, 0.9)); }

TEST(PreparationGravity, LeavesABedAtRestUnderItsOwnWeight) {
  for (const double ratio : {-1.0, 1.0}) {
    EXPECT_NEAR(value_of({StageKind::kSettle, "floor_force_over_weight"}, 1, only(EffectId::kPreparationGravity, ratio)), 1, 0.02);
  }
}

TEST(Breakage, BreaksClustersAndWeakens) {
  const EffectSet on = only(EffectId::kBreakage, 5);
  EXPECT_GT(value_of({StageKind::kStress, "clusters_broken", 5000}, 1, on), 5);
  expect_down(sigma1(5), on);
}

TEST(GrainDensity, ScalesTheBedsDensityAndNotItsPlaces) {
  const EffectSet on = only(EffectId::kGrainDensity, 0.05);
  const Observable void_ratio{StageKind::kFabric, "void_ratio"};
  EXPECT_NEAR(value_of(kDensity, 1, on) / value_of(kDensity, 1, {}), 1.05, 1e-12);
  EXPECT_NEAR((1 + value_of(void_ratio, 1, on)) / (1 + value_of(void_ratio, 1, {})), 1 / 1.05, 1e-12);
}

TEST(Apparatus, ChangesTheReadingOfTheSameRun) {
  expect_down(kModulus, only(EffectId::kFrameCompliance, 3e-6));
  for (const auto& [id, strength] : {std::pair{EffectId::kLoadCellOffset, 500.0}, {EffectId::kLoadCellGain, 0.2}}) {
    expect_up(sigma1(1.25), only(id, strength));
  }
}

}  // namespace
}  // namespace regolab
