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

}  // namespace
}  // namespace regolab
