#include "client/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace regolab::client {
namespace {

TEST(NumberText, ShortestReadsBackToTheSameBits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1e6, 1e6);
  for (int i = 0; i < 1000; ++i) {
    const double value = uniform(random) * std::pow(10.0, i % 40 - 20);
    EXPECT_EQ(std::stod(shortest(value)), value);
  }
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(NumberText, SignificantKeepsTrailingZeros) {
  EXPECT_EQ(significant(1.7, 3), "1.70");
  EXPECT_EQ(significant(12345.6, 4), "12346");
  EXPECT_EQ(significant(-0.012345, 3), "-0.0123");
  EXPECT_EQ(significant(0, 3), "0.00");
  EXPECT_EQ(significant(2.5e-12, 3), "2.50e-12");
  EXPECT_EQ(significant(std::nan(""), 3), "-");
}

TEST(NumberText, FixedHasNoNegativeZero) {
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(-0.01, 2), "-0.01");
}

TEST(NumberText, UncertaintyDecidesTheDecimals) {
  EXPECT_EQ(with_uncertainty(3.46831, 0.0123), "3.468 ±0.012");
  EXPECT_EQ(with_uncertainty(3.46831, 1.5), "3.5 ±1.5");
  EXPECT_EQ(with_uncertainty(346.831, 25.0), "347 ±25");
  EXPECT_EQ(with_uncertainty(3.46831, std::nullopt), "3.468");
  EXPECT_EQ(with_uncertainty(3.46831, 0.0), "3.468");
}

TEST(NumberText, ProbabilitiesAndTimes) {
  EXPECT_EQ(p_text(0.0004), "<0.001");
  EXPECT_EQ(p_text(0.0123), "0.012");
  EXPECT_EQ(p_text(0.31), "0.31");
  EXPECT_EQ(duration_text(45), "45 s");
  EXPECT_EQ(duration_text(720), "12 min");
  EXPECT_EQ(duration_text(12000), "3 h 20 min");
}

TEST(NumberText, LabelsThatAreNumbers) {
  EXPECT_EQ(as_number("5e4"), 5e4);
  EXPECT_EQ(as_number("mixture"), std::nullopt);
  EXPECT_EQ(as_number("0.1x"), std::nullopt);
  EXPECT_EQ(as_number("nan"), std::nullopt);
}

}  // namespace
}  // namespace regolab::client
