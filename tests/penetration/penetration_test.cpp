/// Plates pushed into a small settled bed: the force rises with depth and with thickness, and comes back from the specification alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "vocab/units.h"
#include "worker/stage/run_stage.h"

namespace regolab {
namespace {

/// The material of the article's Table 15, a bed 30 mm deep; fast, so that it takes seconds.
StageSpec stage(StageKind kind, const PlateSize& plate = {}) {
  StageSpec spec{.kind = kind, .seed = 1, .plate = plate};
  spec.micro = {.friction_angle = 10 * kDegree,
                .normal_stiffness = 3500,
                .normal_damping = 0.2,
                .tangential_stiffness = 3500,
                .tangential_damping = 0.2,
                .largest_diameter = 0.01,
                .kind = ParticleKind::kSix,
                .rotation = Rotation::kXZ,
                .gravity = 9.8};
  spec.numerics.clusters = 500;
  spec.numerics.box_length = 0.036;
  spec.numerics.box_width = 0.032;
  spec.numerics.settle_stiffness_number = 0;
  spec.numerics.inertial_number = 0.1;
  return spec;
}

StageOutput run_whole(const StageSpec& spec, const std::string& bed) {
  auto output = run_stage(spec, bed, "", {});
  EXPECT_TRUE(output.ok()) << output.error().text;
  EXPECT_EQ(output->result.end, StageEnd::kCompleted) << output->result.reason;
  return std::move(*output);
}

const std::string& settled_bed() {
  static const std::string bed = run_whole(stage(StageKind::kSettle), "").bed;
  return bed;
}

const StageResult& pushed_in(double thickness) {
  static std::map<double, StageResult> done;
  if (!done.contains(thickness)) {
    done[thickness] = run_whole(stage(StageKind::kPenetration, {.width = 0.014, .thickness = thickness}), settled_bed()).result;
  }
  return done[thickness];
}

double value(const std::vector<Measurement>& all, const std::string& start) {
  const auto found = std::ranges::find_if(all, [&](const Measurement& m) { return m.id.starts_with(start); });
  EXPECT_NE(found, all.end()) << start;
  return found == all.end() ? 0 : found->value;
}

constexpr double kThin = 0.004, kThick = 0.008;

TEST(Penetration, TakesMoreForceTheDeeperThePlate) {
  for (const double thickness : {kThin, kThick}) {
    const auto& measured = pushed_in(thickness).measurements;
    EXPECT_GT(value(measured, "penetration_force_0.00_0.25_"), 0);
    EXPECT_GT(value(measured, "penetration_force_0.25_0.50_"), 1.3 * value(measured, "penetration_force_0.00_0.25_")) << thickness;
  }
}

TEST(Penetration, TakesMoreForceTheThickerThePlate) {
  for (const char* id : {"penetration_force_0.00_0.25_", "penetration_force_0.25_0.50_", "penetration_work_"}) {
    EXPECT_GT(value(pushed_in(kThick).measurements, id), 1.3 * value(pushed_in(kThin).measurements, id)) << id;
  }
}

TEST(Penetration, CurveGoesInHalfMillimetresFromTheSurfaceToHalfTheBed) {
  const StageResult& result = pushed_in(kThin);
  ASSERT_EQ(result.curves.size(), 1u);
  const Curve& curve = result.curves[0];
  EXPECT_EQ(curve.id, "penetration_force_plate_14x4mm");
  EXPECT_LE(curve.x.front(), 0.00025 + 1e-12) << "not after the surface";
  EXPECT_NEAR(curve.x.back(), 0.5 * value(result.numerics, "bed_height"), 0.0008);
  for (std::size_t i = 1; i < curve.x.size(); ++i) EXPECT_NEAR(curve.x[i] - curve.x[i - 1], 0.0005, 1e-12);
  EXPECT_LT(value(result.numerics, "energy_gain"), 1e-3) << "the plate's work pays for all motion";
}

TEST(Penetration, WorkIsTheAreaUnderTheCurve) {
  const StageResult& result = pushed_in(kThick);
  const auto& y = result.curves[0].y;
  const double area = 0.0005 * std::accumulate(y.begin(), y.end(), 0.0);
  EXPECT_NEAR(value(result.measurements, "penetration_work_"), area, 1e-9 * area);
}

TEST(Penetration, OfAPlateThatLeavesNoRoomBesideItIsRefused) {
  const auto refused = run_stage(stage(StageKind::kPenetration, {.width = 0.03, .thickness = 0.003}), settled_bed(), "", {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text.find("plate_width"), std::string::npos) << refused.error().text;
}

}  // namespace
}  // namespace regolab
