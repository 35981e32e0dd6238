#include "scheduler/design/array_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scheduler/design/array_quality.h"

namespace regolab {
namespace {

using ::testing::HasSubstr;

struct Choice {
  const char* wanted;
  std::vector<int> levels;
  const char* name;
};

TEST(ArrayChoice, TakesTheSmallestThatFits) {
  const Choice cases[] = {
      {"auto", {2, 2, 2}, "L4 (2^3)"},
      {"auto", {2, 2, 2, 2}, "L8 (2^7)"},
      {"auto", {4, 2, 2, 2}, "L8 (4^1 2^4)"},
      {"auto", {3, 3, 3, 3}, "L9 (3^4)"},
      {"auto", std::vector<int>(10, 2), "L12 (2^11)"},
      {"auto", {4, 4, 4, 4, 4}, "L16 (4^5)"},
      {"auto", {4, 4, 2, 2, 2, 2}, "L16 (4^2 2^9)"},
      {"auto", {2, 3, 3, 3, 3}, "L18 (2^1 3^7)"},
      {"auto", {6, 3, 3}, "L18 (6^1 3^6)"},
      {"auto", {5, 5, 5}, "L25 (5^6)"},
      {"auto", std::vector<int>(8, 3), "L27 (3^13)"},
      {"auto", std::vector<int>(8, 4), "L32 (4^9 2^1)"},
      {"auto", std::vector<int>(12, 4), "L64 (4^21)"},
      {"auto", {4, 3}, "full factorial (4^1 3^1)"},
      {"auto", {3, 3}, "full factorial (3^2)"},
      {"L16", {4, 4, 4}, "L16 (4^3 2^6)"},
      {"L16 (4^5)", {4, 4, 4}, "L16 (4^5)"},
      {"L16(2^15)", {2, 2, 2, 2}, "L16 (2^15)"},
      {"L32", {4, 4, 2}, "L32 (4^9 2^1)"},
      {"full", {2, 2, 2}, "full factorial (2^3)"},
  };
  for (const Choice& c : cases) {
    const auto chosen = choose_array(c.wanted, c.levels);
    ASSERT_TRUE(chosen.ok()) << c.name << ": " << chosen.error().text;
    EXPECT_EQ(chosen->name, c.name);
    EXPECT_GE(quality_of(c.levels, chosen->rows).strength, 2) << c.name;
  }
}

/// Whatever mixture of level counts is asked for: what fits is orthogonal in the factors' own levels.
TEST(ArrayChoice, EveryFitIsOrthogonal) {
  for (int a = 2; a <= 9; ++a) {
    for (int b = 2; b <= 9; ++b) {
      for (int c = 2; c <= 9; ++c) {
        const std::vector<int> levels{a, b, b, c};
        const auto chosen = choose_array("auto", levels);
        if (!chosen.ok()) continue;
        EXPECT_GE(quality_of(levels, chosen->rows).strength, 2) << a << " " << b << " " << c << " " << chosen->name;
      }
    }
  }
}

TEST(ArrayChoice, MergesLevelsEvenly) {
  const std::vector<int> levels{2, 2, 4, 4, 4, 4, 4, 4, 4};
  const auto chosen = choose_array("L32", levels);
  ASSERT_TRUE(chosen.ok());
  EXPECT_EQ(chosen->name, "L32 (4^9 2^1)");
  EXPECT_EQ(quality_of(levels, chosen->rows).strength, 2);
}

TEST(ArrayChoice, NamesWhatWouldFit) {
  const std::vector<int> odd_one{4, 4, 4, 3, 4, 4, 4, 4};
  EXPECT_THAT(choose_array("L32", odd_one).error().text,
              ::testing::AllOf(HasSubstr("do not fit L32 (2^31) or (4^9 2^1) or (8^1 4^8) (4^3 3^1 4^4 is needed)"),
                               HasSubstr("7 factors of 4 levels fit L32 (4^9 2^1)"),
                               HasSubstr("1 factor of 3 levels fit L9 (3^4)")));
  EXPECT_THAT(choose_array("L9", std::vector<int>(8, 4)).error().text,
              HasSubstr("do not fit L9 (3^4) (4^8 is needed) use L32 (4^9 2^1)"));
  EXPECT_THAT(choose_array("auto", std::vector<int>{11, 13, 2}).error().text,
              ::testing::AllOf(HasSubstr("fit no built-in array"), HasSubstr("1 factor of 11 levels fit no built-in array"),
                               HasSubstr("`full` takes 286 points")));
  EXPECT_THAT(choose_array("L10", std::vector<int>{2}).error().text,
              ::testing::AllOf(HasSubstr("unknown array 'L10'"), HasSubstr("L12 (2^11)")));
  EXPECT_THAT(choose_array("full", std::vector<int>(9, 9)).error().text, HasSubstr("more than 4096 points"));
}

}  // namespace
}  // namespace regolab
