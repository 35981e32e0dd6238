#include <gtest/gtest.h>

#include <cmath>

#include "input/number_text.h"
#include "input/report.h"
#include "input/suggestion.h"

namespace regolab {
namespace {

TEST(NumberText, IsPlainWhereItCan) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(number_text(1e-5), "0.00001");
  EXPECT_EQ(number_text(-2.5), "-2.5");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1e300), "1e+300");
}

TEST(LeadingNumber, SplitsNumberFromUnit) {
  EXPECT_EQ(leading_number("7.5e4 N/m")->value, 7.5e4);
  EXPECT_EQ(leading_number("7.5e4 N/m")->rest, "N/m");
  EXPECT_EQ(leading_number("1cm")->rest, "cm");
  EXPECT_EQ(leading_number("  +3 ")->value, 3);
  EXPECT_EQ(leading_number("-.5")->value, -0.5);
}

TEST(LeadingNumber, GivesWhatIsNotFiniteSoThatItCanBeNamed) {
  EXPECT_TRUE(std::isnan(leading_number(".nan")->value));
  EXPECT_TRUE(std::isnan(leading_number("NaN cm")->value));
  EXPECT_EQ(leading_number("-.inf")->value, -INFINITY);
  EXPECT_EQ(leading_number("1e999 m")->value, INFINITY);
}

TEST(LeadingNumber, IsNothingForText) {
  for (const char* text : {"", " ", "cm", "--5", "information", "nano", ".x", "+", "-", "e5"})
    EXPECT_FALSE(leading_number(text)) << text;
}

TEST(Closest, ForgivesTwoSlipsAndTheCase) {
  constexpr std::string_view kNames[] = {"theta_F", "K_N", "rotation", "seeds"};
  EXPECT_EQ(closest("rotaton", kNames), "rotation");
  EXPECT_EQ(closest("theta_f", kNames), "theta_F");
  EXPECT_EQ(closest("k_n", kNames), "K_N");
  EXPECT_EQ(closest("sedes", kNames), "seeds");
  EXPECT_EQ(closest("gravity", kNames), "");
  EXPECT_EQ(closest("", kNames), "");
  EXPECT_EQ(closest(std::string(1000, 'a'), kNames), "");
}

TEST(Excerpt, IsShortAndPrintable) {
  EXPECT_EQ(excerpt("a\nb\x1b[31m"), "a?b?[31m");
  EXPECT_EQ(excerpt(std::string(100, 'x')), std::string(60, 'x') + "...");
  EXPECT_EQ(excerpt(std::string(59, 'x') + "\xC3\xA9zzz"), std::string(59, 'x') + "...");  // no half letters
}

}  // namespace
}  // namespace regolab
