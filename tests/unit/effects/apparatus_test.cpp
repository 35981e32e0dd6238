/// What an apparatus makes of a stress test, against the algebra.
#include "apparatus/apparatus.h"

#include <gtest/gtest.h>

namespace regolab {
namespace {

constexpr double kSigma3 = 2500, kEnd = 0.2;

/// Stress rises to a peak of 10 kPa at 5 % strain and stays.
std::vector<StressSample> curve() {
  std::vector<StressSample> samples;
  for (int i = 0; i <= 80; ++i) {
    const double strain = 0.0025 * i, sigma1 = std::min(kSigma3 + strain / 0.05 * 7500, 10000.0);
    samples.push_back({.strain = strain, .top = sigma1, .bottom = sigma1, .lateral_x = kSigma3, .lateral_y = kSigma3, .volumetric_strain = 0.1 * strain});
  }
  return samples;
}

StageResult result_of(const std::vector<StressSample>& samples) {
  StageResult out;
  add_stress_results(samples, kSigma3, kEnd, 0.8, out);
  return out;
}

double number(const StageResult& result, std::string_view id) {
  for (const Measurement& m : result.measurements) {
    if (m.id == id) return m.value;
  }
  ADD_FAILURE() << id;
  return 0;
}

TEST(Apparatus, ThatIsIdealLeavesEverySampleAsItIs) {
  const auto samples = curve(), same = as_measured(samples, {});
  ASSERT_EQ(same.size(), samples.size());
  for (std::size_t i = 0; i < same.size(); ++i) EXPECT_EQ(same[i].strain, samples[i].strain);
}

TEST(Apparatus, FrameAndSeatAddToTheStrainAndTheCellErrsInStress) {
  const Apparatus bad{.frame_compliance = 1e-6, .seating = 0.01, .load_cell_offset = 300, .load_cell_gain = 0.1};
  const auto samples = curve(), read = as_measured(samples, bad);
  ASSERT_EQ(read.size(), samples.size() + 1);
  EXPECT_EQ(read[0].strain, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_NEAR(read[i + 1].strain, samples[i].strain + 1e-6 * (samples[i].sigma1() - kSigma3) + 0.01, 1e-15);
    EXPECT_NEAR(read[i + 1].sigma1(), 1.1 * samples[i].sigma1() + 300, 1e-9);
    EXPECT_EQ(read[i + 1].sigma3(), kSigma3);
    EXPECT_EQ(read[i + 1].volumetric_strain, samples[i].volumetric_strain);
  }
}

/// A line from (0, sigma3): half the peak deviator at strain 0.025; the frame in series with it.
TEST(Apparatus, FrameStandsInSeriesWithTheSpecimen) {
  const double compliance = 2e-6;
  const StageResult read = result_of(as_measured(curve(), {.frame_compliance = compliance}));
  EXPECT_NEAR(number(result_of(curve()), "E50_at_sigma3_2.5kPa"), 3750 / 0.025, 1e-6);
  EXPECT_NEAR(number(read, "E50_at_sigma3_2.5kPa"), 1 / (0.025 / 3750 + compliance), 1e-6);
  EXPECT_NEAR(number(read, "sigma1_peak_at_sigma3_2.5kPa"), 10000, 1e-9);
}

TEST(Apparatus, OfAStoredResultIsThatOfItsSamples) {
  const Apparatus bad{.frame_compliance = 3e-6, .seating = 0.004, .load_cell_offset = -200, .load_cell_gain = 0.05};
  const StageResult direct = result_of(as_measured(curve(), bad));
  const auto stored = as_measured(result_of(curve()), kSigma3, kEnd, bad);
  ASSERT_TRUE(stored.ok()) << stored.error().text;
  EXPECT_EQ(stored->measurements, direct.measurements);
  EXPECT_EQ(stored->curves, direct.curves);
  EXPECT_FALSE(as_measured(StageResult{}, kSigma3, kEnd, bad).ok());
}

}  // namespace
}  // namespace regolab
