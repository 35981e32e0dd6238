/// Table 1's clusters and the beds made of them, over many draws [article Sec. 2.2, 2.3; volumes from the restored
/// geometry].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "worker/generate/clump_shapes.h"
#include "worker/generate/parents.h"
#include "worker/generate/random.h"
#include "worker/generate/replacement.h"

namespace regolab::generate {
namespace {

constexpr double kRadius = 0.7;  // of the parent; shapes scale with it
constexpr int kDraws = 20000;

AxisRatios draw(int i) {
  const Random random(17);
  const auto u = [&](std::uint64_t k) { return random.uniform(Purpose::kAspect, static_cast<std::uint64_t>(i), k); };
  return axis_ratios(u(0), u(1), u(2));
}

struct Facts {
  int touching = 0;         ///< pairs whose gap is round-off
  double deepest = 0;       ///< overlap between spheres [parent radius]
  dem::Vec3 extent{};       ///< along x, y, z [parent radius]
  double volume_share = 0;  ///< solid volume over the parent's
  double farthest = 0;      ///< from the parent centre [parent radius]
};

Facts facts_of(const Clump& clump) {
  Facts facts;
  const std::size_t n = clump.radius.size();
  for (std::size_t i = 0; i < n; ++i) {
    facts.volume_share += std::pow(clump.radius[i] / kRadius, 3);
    for (std::size_t j = i + 1; j < n; ++j) {
      const auto &p = clump.centre[i], &q = clump.centre[j];
      const double gap = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) - clump.radius[i] - clump.radius[j];
      if (std::abs(gap) < 1e-14) ++facts.touching;
      facts.deepest = std::max(facts.deepest, -gap / kRadius);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = 1e9, high = -1e9;
    for (std::size_t i = 0; i < n; ++i) {
      low = std::min(low, clump.centre[i][axis] - clump.radius[i]);
      high = std::max(high, clump.centre[i][axis] + clump.radius[i]);
    }
    facts.extent[axis] = (high - low) / kRadius;
  }
  facts.farthest = farthest_point(clump) / kRadius;
  return facts;
}

/// Checks the volume share's range and mean over all draws.
class VolumeShare {
 public:
  void add(double share) {
    low_ = std::min(low_, share);
    high_ = std::max(high_, share);
    sum_ += share;
  }
  void expect(double mean, double low, double high) const {  // three digits, as the restored geometry states them
    EXPECT_NEAR(sum_ / kDraws, mean, 1e-3);
    EXPECT_NEAR(low_, low, 1e-3);
    EXPECT_NEAR(high_, high, 1e-3);
  }

 private:
  double low_ = 1e9, high_ = -1e9, sum_ = 0;
};

TEST(TwoElement, TouchesOnceSpansItsParentAndFillsItsShare) {
  const struct {
    TwoKind kind;
    double mean, low, high;
  } kinds[] = {
      {TwoKind::kAC, 0.274, 0.263, 0.287}, {TwoKind::kAB, 0.482, 0.439, 0.529}, {TwoKind::kBC, 0.476, 0.438, 0.516}};
  for (const auto& expected : kinds) {
    VolumeShare share;
    for (int i = 0; i < kDraws; ++i) {
      const AxisRatios ratios = draw(i);
      const double ratio = expected.kind == TwoKind::kAC   ? ratios.c_over_a
                           : expected.kind == TwoKind::kAB ? ratios.b_over_a
                                                           : ratios.c_over_b;
      const Facts facts = facts_of(two_element(kRadius, expected.kind, ratios));
      ASSERT_EQ(facts.touching, 1);
      ASSERT_NEAR(facts.extent[1], 2, 1e-14);
      ASSERT_NEAR(facts.extent[0], 2 * std::max(ratio, 1 - ratio), 1e-14);
      ASSERT_NEAR(facts.farthest, 1, 1e-14);
      share.add(facts.volume_share);
    }
    share.expect(expected.mean, expected.low, expected.high);
  }
}

TEST(FourElement, TouchesFiveTimesHasItsThreeExtentsAndStaysInsideItsParent) {
  VolumeShare share;
  for (int i = 0; i < kDraws; ++i) {
    const AxisRatios ratios = draw(i);
    const Facts facts = facts_of(four_element(kRadius, ratios));
    ASSERT_EQ(facts.touching, 5);
    ASSERT_LT(facts.deepest, 1e-14);
    ASSERT_NEAR(facts.extent[0], 2, 1e-14);
    ASSERT_NEAR(facts.extent[1], 2 * ratios.b_over_a, 1e-14);
    ASSERT_NEAR(facts.extent[2], 2 * ratios.c_over_a, 1e-14);
    ASSERT_LE(facts.farthest, 1.01) << "within half the clearance between parents";
    share.add(facts.volume_share);
  }
  share.expect(0.304, 0.293, 0.315);
}

TEST(SixElement, TouchesNineTimesHasItsThreeExtentsAndStaysInsideItsParent) {
  VolumeShare share;
  for (int i = 0; i < kDraws; ++i) {
    const AxisRatios ratios = draw(i);
    const Facts facts = facts_of(six_element(kRadius, ratios));
    ASSERT_EQ(facts.touching, 9);
    ASSERT_LT(facts.deepest, 1e-14);
    ASSERT_NEAR(facts.extent[0], 2, 1e-14);
    ASSERT_NEAR(facts.extent[1], 2 * ratios.b_over_a, 1e-14);
    ASSERT_NEAR(facts.extent[2], 2 * ratios.c_over_a, 1e-14);
    ASSERT_NEAR(facts.farthest, 1, 1e-14);
    share.add(facts.volume_share);
  }
  share.expect(0.222, 0.212, 0.233);
}

TEST(Generation, OfEveryKindRotationAndSeedLeavesNoOverlapAndNothingOutside) {
  for (const auto kind : {ParticleKind::kTwo, ParticleKind::kFour, ParticleKind::kSix, ParticleKind::kMixture}) {
    for (const auto rotation : {Rotation::kNone, Rotation::kX, Rotation::kZ, Rotation::kXZ}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Micro micro{.largest_diameter = 0.01, .kind = kind, .rotation = rotation};
        const Random random(seed);
        const double length = 0.027, width = 0.022;
        const auto parents = place_parents(parent_diameters(200, 0.01, random), length, width, 0.3, 0.02, random);
        ASSERT_TRUE(parents.has_value());
        dem::World world;
        replace_parents(*parents, micro, 0.4, random, world);
        EXPECT_LE(deepest_overlap_between_clusters(world), 0.0);
        const dem::Centres at = dem::sphere_centres(world.bodies, world.spheres);
        for (std::size_t s = 0; s < at.x.size(); ++s) {
          const double r = world.spheres.radius[s];
          ASSERT_GE(at.x[s], r);
          ASSERT_LE(at.x[s], length - r);
          ASSERT_GE(at.y[s], r);
          ASSERT_LE(at.y[s], width - r);
          ASSERT_GE(at.z[s], r);
        }
      }
    }
  }
}

TEST(Generation, DealsTheMixtureInExactThirdsAndTheSizesUniformly) {
  const Random random(5);
  const std::vector<double> diameters = parent_diameters(300, 0.01, random);
  EXPECT_NEAR(std::accumulate(diameters.begin(), diameters.end(), 0.0) / 300, 0.006, 1e-5);
  EXPECT_TRUE(std::is_sorted(diameters.rbegin(), diameters.rend()));
  EXPECT_GE(diameters.back(), 0.002);
  EXPECT_LE(diameters.front(), 0.01);
  const auto parents = place_parents(diameters, 0.0273, 0.0218, 0.3, 0.02, random);
  dem::World world;
  replace_parents(parents.value(), {.largest_diameter = 0.01, .kind = ParticleKind::kMixture}, 0.4, random, world);
  int of_size[7] = {};
  for (std::size_t b = 0; b + 1 < world.bodies.first_sphere.size(); ++b) {
    ++of_size[world.bodies.first_sphere[b + 1] - world.bodies.first_sphere[b]];
  }
  EXPECT_EQ(of_size[2], 100);
  EXPECT_EQ(of_size[4], 100);
  EXPECT_EQ(of_size[6], 100);
}

TEST(Generation, MassAndInertiaOfTangentSpheresAddUp) {
  dem::World world;
  const Clump clump = six_element(0.01, axis_ratios(0.5, 0.5, 0.5));
  dem::add_cluster({.centre = clump.centre, .radius = clump.radius, .density = 2930}, world.bodies, world.spheres);
  double mass = 0, about_x = 0, about_y = 0,
         about_z = 0;  // the six-element cluster is symmetric: its centre is at the origin
  for (std::size_t i = 0; i < clump.radius.size(); ++i) {
    const double m = 2930 * 4.0 / 3 * std::numbers::pi * std::pow(clump.radius[i], 3);
    const double own = 0.4 * m * clump.radius[i] * clump.radius[i];
    const auto& c = clump.centre[i];
    mass += m;
    about_x += own + m * (c[1] * c[1] + c[2] * c[2]);
    about_y += own + m * (c[0] * c[0] + c[2] * c[2]);
    about_z += own + m * (c[0] * c[0] + c[1] * c[1]);
  }
  double expected[] = {about_x, about_y, about_z};
  std::sort(std::begin(expected), std::end(expected));
  EXPECT_NEAR(world.bodies.mass[0] / mass, 1, 1e-13);
  EXPECT_NEAR(world.bodies.inverse_ix[0] * expected[0], 1, 1e-12);
  EXPECT_NEAR(world.bodies.inverse_iy[0] * expected[1], 1, 1e-12);
  EXPECT_NEAR(world.bodies.inverse_iz[0] * expected[2], 1, 1e-12);
}

}  // namespace
}  // namespace regolab::generate
