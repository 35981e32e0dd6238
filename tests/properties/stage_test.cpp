/// Whole stages: the same bits on 1 and 2 threads, and however often they were stopped and resumed.
#include <gtest/gtest.h>

#include <set>

#include "vocab/units.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

StageSpec small_stage(StageKind kind) {
  StageSpec spec{.kind = kind, .seed = 7};
  spec.micro = {.friction_angle = 30 * kDegree,
                .normal_stiffness = 5e4,
                .normal_damping = 0.5,
                .tangential_stiffness = 2.5e4,
                .tangential_damping = 0.5,
                .largest_diameter = 0.01,
                .kind = ParticleKind::kMixture,
                .rotation = Rotation::kXZ};
  spec.numerics.clusters = 40;
  spec.numerics.box_length = 0.018;
  spec.numerics.box_width = 0.016;
  spec.numerics.settle_stiffness_number = 100;
  spec.numerics.stress_stiffness_number = 200;
  spec.numerics.axial_strain = 0.06;
  spec.numerics.inertial_number = 2e-2;
  if (kind == StageKind::kStress) spec.confining_stress = 2500;
  if (kind == StageKind::kPenetration) spec.plate = {.width = 0.005, .thickness = 0.003};
  return spec;
}

StageOutput run_whole(const StageSpec& spec, const std::string& bed, int threads = 1) {
  auto output = run_stage(spec, bed, "", {.threads = threads});
  EXPECT_TRUE(output.ok()) << output.error().text;
  EXPECT_EQ(output->result.end, StageEnd::kCompleted) << output->result.reason;
  return std::move(*output);
}

const std::string& settled_bed() {
  static const std::string bed = run_whole(small_stage(StageKind::kSettle), "").bed;
  return bed;
}

/// Stops the stage at every checkpoint from a second run's point of view: each is resumed to the end.
void expect_every_checkpoint_leads_to_the_same_end(const StageSpec& spec, const std::string& bed) {
  std::vector<std::string> checkpoints;
  const auto whole =
      run_stage(spec, bed, "",
                {.on_checkpoint = [&](const std::string& bytes) { checkpoints.push_back(bytes); }, .checkpoint_every_s = 0});
  ASSERT_TRUE(whole.ok());
  ASSERT_GE(checkpoints.size(), 4u);
  for (const std::size_t part : {1u, 4u, 7u}) {  // eighths of the way
    const auto resumed = run_stage(spec, bed, checkpoints[checkpoints.size() * part / 8], {});
    ASSERT_TRUE(resumed.ok()) << resumed.error().text;
    EXPECT_EQ(resumed->result, whole->result);
    EXPECT_EQ(resumed->bed, whole->bed);
    EXPECT_EQ(resumed->final_state, whole->final_state);
  }
}

class Stage : public testing::TestWithParam<StageKind> {
 protected:
  StageSpec spec() const { return small_stage(GetParam()); }
  std::string bed() const { return needs_bed(GetParam()) ? settled_bed() : ""; }
};

TEST_P(Stage, GivesTheSameBitsOnTwoThreads) {
  const StageOutput one = run_whole(spec(), bed()), two = run_whole(spec(), bed(), 2);
  EXPECT_EQ(one.result, two.result);
  EXPECT_EQ(one.bed, two.bed);
  EXPECT_EQ(one.final_state, two.final_state);
}

TEST_P(Stage, ResumedFromAnyCheckpointEndsWithTheSameBits) { expect_every_checkpoint_leads_to_the_same_end(spec(), bed()); }

TEST_P(Stage, StoppedByRequestLeavesACheckpointThatGoesOn) {
  std::stop_source stop;
  std::string last;
  int seen = 0;
  const auto cut = run_stage(spec(), bed(), "",
                             {.on_checkpoint =
                                  [&](const std::string& bytes) {
                                    last = bytes;
                                    if (++seen == 3) stop.request_stop();
                                  },
                              .checkpoint_every_s = 0,
                              .stop = stop.get_token()});
  ASSERT_TRUE(cut.ok());
  EXPECT_EQ(cut->result.end, StageEnd::kCancelled);
  ASSERT_FALSE(last.empty());
  const auto rest = run_stage(spec(), bed(), last, {});
  ASSERT_TRUE(rest.ok());
  EXPECT_EQ(rest->result, run_whole(spec(), bed()).result);
}

TEST_P(Stage, RefusesADamagedOrForeignCheckpoint) {
  std::string checkpoint;
  std::stop_source stop;
  static_cast<void>(run_stage(spec(), bed(), "",
                              {.on_checkpoint =
                                   [&](const std::string& bytes) {
                                     checkpoint = bytes;
                                     stop.request_stop();
                                   },
                               .checkpoint_every_s = 0,
                               .stop = stop.get_token()}));
  ASSERT_FALSE(checkpoint.empty());
  std::string damaged = checkpoint;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  EXPECT_EQ(run_stage(spec(), bed(), damaged, {}).error().code, Code::kDataLoss);
  EXPECT_EQ(run_stage(spec(), bed(), checkpoint.substr(0, checkpoint.size() / 2), {}).error().code, Code::kDataLoss);
  StageSpec other = spec();
  other.micro.friction_angle *= 1.01;
  EXPECT_FALSE(run_stage(other, bed(), checkpoint, {}).ok());
}

INSTANTIATE_TEST_SUITE_P(SettleReposeStressPenetration, Stage,
                         testing::Values(StageKind::kSettle, StageKind::kRepose, StageKind::kStress, StageKind::kPenetration));

/// Everything at once that has a memory: rolling springs, broken clusters, a bed prepared otherwise than it is left.
StageSpec with_effects(StageKind kind) {
  StageSpec spec = small_stage(kind);
  for (const auto& [id, strength] : {std::pair{EffectId::kRollingResistance, 0.2}, {EffectId::kCohesion, 300.0}, {EffectId::kHertzianContact, 0.5},
                                     {EffectId::kWallFriction, 0.3}, {EffectId::kBoundaryCompliance, 3.0}, {EffectId::kPreparationGravity, 0.3},
                                     {EffectId::kPreparationFriction, 0.5}, {EffectId::kBreakage, 5.0}, {EffectId::kSeating, 0.002}}) {
    spec.effects[id] = strength;
  }
  spec.numerics.axial_strain = 0.02;
  return spec;
}

TEST(StagesWithEffects, ResumedFromAnyCheckpointEndWithTheSameBitsOnAnyThreads) {
  const std::string bed = run_whole(with_effects(StageKind::kSettle), "").bed;
  for (const StageKind kind : {StageKind::kSettle, StageKind::kStress}) {
    SCOPED_TRACE(name_of(kind));
    const StageSpec spec = with_effects(kind);
    const std::string from = needs_bed(kind) ? bed : "";
    expect_every_checkpoint_leads_to_the_same_end(spec, from);
    if (kind == StageKind::kSettle) continue;  // two threads on few cores wait for one another
    EXPECT_EQ(run_whole(spec, from).result, run_whole(spec, from, 2).result);
  }
}

TEST(StagesWithEffects, DoNotSeeWhatActsElsewhere) {
  StageSpec spec = small_stage(StageKind::kRepose);
  spec.effects[EffectId::kLoadingRate] = 1;
  spec.effects[EffectId::kBreakage] = 100;
  EXPECT_EQ(run_whole(spec, settled_bed()).result, run_whole(small_stage(StageKind::kRepose), settled_bed()).result);
}

TEST(StagesWithEffects, OutsideTheirRangeAreRefused) {
  StageSpec spec = small_stage(StageKind::kStress);
  spec.effects[EffectId::kLateralStressOffset] = -2500;
  const auto refused = run_stage(spec, settled_bed(), "", {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text.find("lateral_stress_offset"), std::string::npos) << refused.error().text;
  spec.effects = {};
  spec.effects[EffectId::kRollingResistance] = -0.1;
  EXPECT_FALSE(run_stage(spec, settled_bed(), "", {}).ok());
}

TEST(Fabric, IsAPureFunctionOfTheBed) {
  const StageSpec spec = small_stage(StageKind::kFabric);
  EXPECT_EQ(run_whole(spec, settled_bed()).result, run_whole(spec, settled_bed(), 2).result);
}

TEST(Stages, OnTheBedOfAnotherSpecificationAreRefused) {
  StageSpec other = small_stage(StageKind::kFabric);
  other.seed = 8;
  const auto refused = run_stage(other, settled_bed(), "", {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Code::kDataLoss);
}

}  // namespace
}  // namespace regolab
