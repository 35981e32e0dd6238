#include "input/job_file.h"

#include <gtest/gtest.h>

#include "support/diagnostics.h"
#include "vocab/profile.h"
#include "vocab/units.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kMicro =
    "micro: {theta_F: 20 degree, K_N: 1e5 N/m, eta_N: 0.25 N.s/m, K_T: 7.5e4 N/m, eta_T: 1 N.s/m, L_S: 1 cm, N_E: 6, "
    "rotation: none}\n";

Job good(const std::string& text) {
  const Read<Job> read = read_job(text, "job.yaml");
  EXPECT_THAT(read.diagnostics, IsEmpty());
  return read.value.value_or(Job{});
}

TEST(JobFile, ReadsTheExample) {
  const Job job = good(testing_support::read_file(REGOLAB_SOURCE "/client/examples/job.yaml"));
  EXPECT_EQ(job.profile, "quick");
  EXPECT_EQ(job.seed, 1u);
  EXPECT_EQ(job.numerics.clusters, 300);
  EXPECT_DOUBLE_EQ(job.numerics.box_length, 0.0363);
  EXPECT_DOUBLE_EQ(job.numerics.box_width, 0.0218);
  EXPECT_DOUBLE_EQ(job.micro.friction_angle, 20 * kDegree);
  EXPECT_DOUBLE_EQ(job.micro.normal_stiffness, 1e5);
  EXPECT_DOUBLE_EQ(job.micro.normal_damping, 0.25);
  EXPECT_DOUBLE_EQ(job.micro.tangential_stiffness, 7.5e4);
  EXPECT_DOUBLE_EQ(job.micro.tangential_damping, 1);
  EXPECT_DOUBLE_EQ(job.micro.largest_diameter, 0.01);
  EXPECT_EQ(job.micro.kind, ParticleKind::kSix);
  EXPECT_EQ(job.micro.rotation, Rotation::kNone);
  EXPECT_TRUE(job.repose);
  EXPECT_THAT(job.confining_stresses, ElementsAre(1250, 2500, 5000, 10000));
}

TEST(JobFile, ShortestJobTakesTheProfileAndAllTests) {
  const Job job = good(kMicro);
  EXPECT_EQ(job.numerics, Numerics{});
  EXPECT_EQ(job.micro.grain_density, 2930);
  EXPECT_EQ(job.micro.gravity, 1.63);
  EXPECT_TRUE(job.repose);
  EXPECT_EQ(job.confining_stresses.size(), 4u);
}

TEST(JobFile, ProfileThenOverrides) {
  const Job job = good(
      "profile: article\nparticles: 50\nnumerics: {axial_strain: 25 %, settle_stiffness_number: 0, step_fraction: 0.075}\n" +
      kMicro);
  Numerics expected = *profile("article");
  expected.clusters = 50;
  expected.axial_strain = 0.25;
  expected.settle_stiffness_number = 0;
  expected.step_fraction = 0.075;
  EXPECT_EQ(job.numerics, expected);
}

TEST(JobFile, OnlyTheTestsAskedFor) {
  const Job job = good("tests: [density]\n" + kMicro);
  EXPECT_FALSE(job.repose);
  EXPECT_THAT(job.confining_stresses, IsEmpty());
}

TEST(JobFile, PlatesOfThePenetrationTestAreTheArticlesUnlessSaid) {
  const std::string box = "box: {length: 8 cm, width: 8 cm}\n";
  EXPECT_THAT(good("tests: [penetration]\n" + box + kMicro).plates,
              ElementsAre(PlateSize{0.03, 0.003}, PlateSize{0.03, 0.005}, PlateSize{0.03, 0.01}));
  EXPECT_THAT(good("tests: [penetration]\npenetration: {plates: [1 cm, 2 mm], width: 25 mm}\n" + box + kMicro).plates,
              ElementsAre(PlateSize{0.025, 0.002}, PlateSize{0.025, 0.01}));
  EXPECT_THAT(good("penetration: {plates: [2 mm]}\n" + kMicro).plates, IsEmpty()) << "not among the tests";
  EXPECT_THAT(good(kMicro).plates, IsEmpty());
}

TEST(JobFile, ReadsThePenetrationExample) {
  const Job job = good(testing_support::read_file(REGOLAB_SOURCE "/client/examples/penetration.yaml"));
  EXPECT_EQ(job.plates.size(), 3u);
  EXPECT_DOUBLE_EQ(job.micro.normal_stiffness, 3500);
  EXPECT_FALSE(job.repose);
}

TEST(JobFile, PressuresAreSorted) {
  EXPECT_THAT(good("stress: {sigma3: [0.02 MPa, 500 Pa]}\n" + kMicro).confining_stresses, ElementsAre(500, 20000));
}

TEST(JobFile, DampingRatioAndOtherMaterial) {
  const Job job = good(
      "micro:\n  theta_F: 0.5 rad\n  K_N: 3.5 kN/m\n  eta_N: 0.2\n  K_T: 3500 N/m\n  eta_T: 20 %\n  L_S: 10 mm\n  N_E: "
      "mixture\n  rotation: XZ\n"
      "  damping_unit: ratio\n  particle_density: 2.7 g/cm3\n  gravity: 980 cm/s2\n");
  EXPECT_EQ(job.micro.damping_unit, DampingUnit::kRatio);
  EXPECT_DOUBLE_EQ(job.micro.normal_damping, 0.2);
  EXPECT_DOUBLE_EQ(job.micro.tangential_damping, 0.2);
  EXPECT_DOUBLE_EQ(job.micro.normal_stiffness, 3500);
  EXPECT_EQ(job.micro.kind, ParticleKind::kMixture);
  EXPECT_EQ(job.micro.rotation, Rotation::kXZ);
  EXPECT_DOUBLE_EQ(job.micro.grain_density, 2700);
  EXPECT_DOUBLE_EQ(job.micro.gravity, 9.8);
}

TEST(JobFile, WindowsLineEndsAndByteOrderMarkAreFine) {
  std::string text = "\xEF\xBB\xBFprofile: quick\r\n" + kMicro;
  text.back() = '\r';
  good(text + "\n");
}

}  // namespace
}  // namespace regolab
