/// The table of effects: names, texts, files, keys, and which stages see which effect.
#include <gtest/gtest.h>

#include <set>

#include "input/job_file.h"
#include "vocab/canonical.h"

namespace regolab {
namespace {

constexpr StageKind kKinds[] = {StageKind::kSettle, StageKind::kFabric, StageKind::kRepose, StageKind::kStress, StageKind::kPenetration};

EffectSet everything() {
  EffectSet all;
  for (const EffectInfo& info : all_effects()) all[info.id] = info.high / 3 + info.version * 1e-7;
  return all;
}

TEST(EffectTable, IsInTheOrderOfItsIdsCompleteAndNeutralAtZero) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < all_effects().size(); ++i) {
    const EffectInfo& info = all_effects()[i];
    EXPECT_EQ(static_cast<std::size_t>(info.id), i);
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(find_effect(info.name), &info);
    EXPECT_TRUE(info.low <= 0 && info.high > 0) << info.name << ": 0 must leave it out";
    EXPECT_TRUE(info.prior_low >= info.low && info.prior_high <= info.high && info.prior_low < info.prior_high) << info.name;
    EXPECT_TRUE(!info.logarithmic || info.prior_low > 0) << info.name;
    EXPECT_NE(info.acts_in, 0U) << info.name;
    for (const std::string_view text : {info.parameter, info.si, info.law, info.moves, info.source}) EXPECT_FALSE(text.empty()) << info.name;
  }
  EXPECT_EQ(find_effect("friction"), nullptr);
  EXPECT_FALSE(EffectSet{}.any());
}

TEST(EffectText, IsSortedExactAndReadBack) {
  EffectSet some;
  some[EffectId::kRollingResistance] = 0.3;
  some[EffectId::kCohesion] = 200;
  EXPECT_EQ(effects_text(some), "cohesion=200;rolling_resistance=0.3");
  EXPECT_EQ(effects_text({}), "");
  const EffectSet all = everything();
  EXPECT_EQ(effects_from_text(effects_text(all)), all);
  EXPECT_EQ(effects_from_text(""), EffectSet{});
  for (const char* bad : {"magic=1", "cohesion", "cohesion=", "cohesion=x", "cohesion=1 ", "cohesion=inf"}) {
    EXPECT_FALSE(effects_from_text(bad)) << bad;
  }
}

TEST(EffectKeys, OfStagesWithoutEffectsAreThoseOfBefore) {
  for (const StageKind kind : kKinds) {
    StageSpec spec{.kind = kind};
    EXPECT_EQ(canonical_text(spec).find("effect"), std::string::npos);
    spec.effects[EffectId::kRollingVariant] = 1;  // without its effect it says nothing
    EXPECT_EQ(canonical_text(spec), canonical_text(StageSpec{.kind = kind}));
  }
}

TEST(EffectKeys, TellEveryEffectInTheStagesWhereItActsAndNowhereElse) {
  for (const EffectInfo& info : all_effects()) {
    for (const StageKind kind : kKinds) {
      StageSpec base{.kind = kind};
      if (info.variant_of) base.effects[*info.variant_of] = 0.5;
      StageSpec on = base;
      on.effects[info.id] = 1;
      const bool acts = (info.acts_in & (acts::kSettle | 1U << static_cast<unsigned>(kind))) != 0;
      EXPECT_EQ(canonical_text(on) != canonical_text(base), acts) << info.name << " in " << name_of(kind);
      on.effects = acting_in(on.effects, kind);
      EXPECT_EQ(on.effects[info.id] != 0, acts) << info.name << " in " << name_of(kind);
    }
  }
}

TEST(EffectKeys, ShareTheBedBetweenStagesThatDifferInTheirTestAlone) {
  StageSpec plain{.kind = StageKind::kStress, .confining_stress = 5000}, stiff_frame = plain, sticky = plain;
  stiff_frame.effects[EffectId::kFrameCompliance] = 1e-6;
  stiff_frame.effects[EffectId::kBoundaryCompliance] = 19;
  sticky.effects[EffectId::kCohesion] = 200;
  EXPECT_EQ(parent_of(stiff_frame), parent_of(plain));
  EXPECT_NE(parent_of(sticky), parent_of(plain));
  EXPECT_EQ(canonical_text(parent_of(sticky)).find("effect cohesion=200 version 1\n") == std::string::npos, false);
}

constexpr const char* kMaterial =
    "micro: {theta_F: 20 degree, K_N: 1e5 N/m, eta_N: 0.25 N.s/m, K_T: 7.5e4 N/m, eta_T: 1 N.s/m, L_S: 1 cm, N_E: 6, rotation: none}\n";

TEST(EffectFiles, AreReadWithTheirUnitsAndVariants) {
  const auto job = read_job(std::string(kMaterial) + "effects: {rolling_resistance: 0.3, rolling_variant: iwashita_oda, cohesion: 0.2 kPa,\n"
                            "  frame_compliance: 0.001 1/kPa, lateral_stress_offset: -800 Pa}\n", "job.yaml");
  ASSERT_TRUE(job.value) << job.diagnostics.at(0).text;
  EXPECT_EQ(effects_text(job.value->effects),
            "cohesion=200;frame_compliance=1e-06;lateral_stress_offset=-800;rolling_resistance=0.3;rolling_variant=1");
}

TEST(EffectFiles, AreRefusedWithTheirPlace) {
  for (const auto& [effects, said] : {std::pair{"cohesion: 200", "has no unit"}, {"cohesoin: 200 Pa", "did you mean"},
                                      {"rolling_resistance: 3", "must be between"}, {"rolling_variant: magic", "choose one of"}}) {
    const auto job = read_job(std::string(kMaterial) + "effects: {" + effects + "}\n", "job.yaml");
    ASSERT_FALSE(job.value) << effects;
    EXPECT_NE(job.diagnostics.at(0).text.find(said), std::string::npos) << job.diagnostics.at(0).text;
    EXPECT_EQ(job.diagnostics.at(0).line, 2);
  }
}

}  // namespace
}  // namespace regolab
