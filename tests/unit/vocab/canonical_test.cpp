#include "vocab/canonical.h"

#include <gtest/gtest.h>

namespace regolab {
namespace {

TEST(CanonicalText, ASettleStageDoesNotDependOnWhatOnlyTheStressTestReads) {
  StageSpec a;
  StageSpec b;
  b.numerics.inertial_number = 1e-3;
  b.confining_stress = 5000;
  EXPECT_EQ(canonical_text(a), canonical_text(b));
  a.kind = b.kind = StageKind::kStress;
  EXPECT_NE(canonical_text(a), canonical_text(b));
}

TEST(CanonicalText, AnExplicitBoxEqualToTheRuleIsTheSameStage) {
  StageSpec by_rule;
  by_rule.micro.largest_diameter = 0.01;
  StageSpec explicit_box = by_rule;
  const Base base = base_of(by_rule);
  explicit_box.numerics.box_length = base.length;
  explicit_box.numerics.box_width = base.width;
  EXPECT_EQ(canonical_text(by_rule), canonical_text(explicit_box));
}

TEST(CanonicalText, EverySeedAndEveryMicroParameterMakesAnotherStage) {
  const StageSpec spec;
  StageSpec other = spec;
  other.seed = 2;
  EXPECT_NE(canonical_text(spec), canonical_text(other));
  other = spec;
  other.micro.tangential_damping = 0.5;
  EXPECT_NE(canonical_text(spec), canonical_text(other));
  other = spec;
  other.micro.damping_unit = DampingUnit::kRatio;
  EXPECT_NE(canonical_text(spec), canonical_text(other));
}

TEST(CanonicalText, TheServoOfTheIsotropicPartIsNamedWhereItIsNotTheUsualOne) {
  StageSpec gentle{.kind = StageKind::kStress};
  EXPECT_EQ(canonical_text(gentle).find("isotropic"), std::string::npos) << "stored results keep their keys";
  gentle.numerics.isotropic_servo_steps = 200;
  EXPECT_NE(canonical_text(gentle).find("isotropic_servo_steps=200\n"), std::string::npos);
}

TEST(CanonicalText, OnlyAPenetrationStageKnowsItsPlate) {
  StageSpec thin{.kind = StageKind::kPenetration, .plate = {.width = 0.03, .thickness = 0.003}};
  StageSpec thick = thin;
  thick.plate.thickness = 0.01;
  EXPECT_NE(canonical_text(thin), canonical_text(thick));
  EXPECT_EQ(parent_of(thin), parent_of(thick));
  thin.kind = thick.kind = StageKind::kRepose;
  EXPECT_EQ(canonical_text(thin), canonical_text(thick));
}

/// Results are stored under these texts: a change of any of them would throw away what was computed.
TEST(CanonicalText, OfTheStagesThatAreStoredStaysLetterByLetter) {
  const std::string kPinnedSettle =
      "regolab stage, physics 3\n[settle]\nbox_length=0.02725680889669\nbox_width=0.021805447117352\nclusters=300\ndamping_unit=0\n"
      "friction_angle=0\ngrain_density=2930\ngravity=1.63\nkind=6\nlargest_diameter=0.01\nmass_floor=0.4\nmost_damping_ratio=0\n"
      "normal_damping=0\nnormal_stiffness=0\nrotation=0\nseed=1\nsettle_stiffness_number=300\nstep_fraction=0.15\n"
      "tangential_damping=0\ntangential_stiffness=0\n";
  StageSpec spec;
  spec.micro.largest_diameter = 0.01;
  spec.numerics.box_length = 0.02725680889669, spec.numerics.box_width = 0.021805447117352;
  EXPECT_EQ(canonical_text(spec), kPinnedSettle);
  spec.kind = StageKind::kFabric;
  EXPECT_EQ(canonical_text(spec), kPinnedSettle + "[fabric]\n");
  spec.kind = StageKind::kRepose;
  EXPECT_EQ(canonical_text(spec), kPinnedSettle + "[repose]\n");
  spec.kind = StageKind::kStress;
  spec.confining_stress = 1250;
  EXPECT_EQ(canonical_text(spec), kPinnedSettle + "[stress]\naxial_strain=0.2\nconfining_stress=1250\ninertial_number=0.01\n"
                                                  "stress_stiffness_number=1000\n");
}

TEST(PlateText, IsWidthTimesThicknessInMillimetres) {
  EXPECT_EQ(plate_text({.width = 0.03, .thickness = 0.003}), "30x3mm");
  EXPECT_EQ(plate_text({.width = 0.0125, .thickness = 0.00075}), "12.5x0.75mm");
}

}  // namespace
}  // namespace regolab
