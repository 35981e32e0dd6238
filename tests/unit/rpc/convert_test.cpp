/// A stage over the wire and back.
#include "rpc/convert.h"

#include <gtest/gtest.h>

#include <limits>

#include "vocab/canonical.h"

namespace regolab {
namespace {

StageSpec stage_with_all_effects() {
  StageSpec spec{.kind = StageKind::kStress, .confining_stress = 2500};
  spec.micro.kind = ParticleKind::kFour;
  for (const EffectInfo& info : all_effects()) spec.effects[info.id] = info.choices.empty() ? info.high / 3 : 1;
  return spec;
}

TEST(StageOverTheWire, ComesBackWithItsEffectsToTheBit) {
  const auto back = from_proto(to_proto(stage_with_all_effects()));
  ASSERT_TRUE(back.ok()) << back.error().text;
  EXPECT_EQ(*back, stage_with_all_effects());
  StageSpec plain = stage_with_all_effects();
  plain.effects = {};
  EXPECT_TRUE(to_proto(plain).effects().empty());
}

TEST(StageOverTheWire, WithAnEffectUnknownHereIsRefused) {
  v1::StageSpec sent = to_proto(stage_with_all_effects());
  (*sent.mutable_effects())["magic"] = 1;
  const auto refused = from_proto(sent);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text.find("magic"), std::string::npos) << refused.error().text;
  sent = to_proto(stage_with_all_effects());
  (*sent.mutable_effects())["cohesion"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(from_proto(sent).ok());
}

}  // namespace
}  // namespace regolab
