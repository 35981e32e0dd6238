// What `regolab article check` must find: notes on the article's own arithmetic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scheduler/analysis/article.h"

namespace regolab::analysis {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const CheckEntry& entry_of(const ArticleCheck& check, const std::string& table, const std::string& entry) {
  return *std::ranges::find_if(check.entries, [&](const CheckEntry& e) { return e.table == table && e.entry == entry; });
}

TEST(ArticleCheck, CountsOfAgreement) {
  std::map<std::string, std::pair<int, int>> agree_of;
  for (const CheckEntry& entry : check_article().entries) {
    agree_of[entry.table].first += entry.agrees ? 1 : 0;
    ++agree_of[entry.table].second;
    EXPECT_EQ(entry.agrees, entry.explanation.empty()) << entry.table << " " << entry.entry;
  }
  EXPECT_EQ(agree_of["Table 4"], (std::pair(8, 8)));
  EXPECT_EQ(agree_of["Table 6"], (std::pair(16, 16)));
  EXPECT_EQ(agree_of["Table 8"], (std::pair(1, 8)));  // only eta_N does not touch test 3's extreme levels
  EXPECT_EQ(agree_of["Table 10"], (std::pair(31, 32)));
  EXPECT_EQ(agree_of["Table 5"], (std::pair(31, 32)));
}

TEST(ArticleCheck, TableEightFollowsOnlyWithTestThreeAsZero) {
  const ArticleCheck check = check_article();
  const CheckEntry& entry = entry_of(check, "Table 8", "repose_angle, K_N");
  EXPECT_EQ(entry.printed, 8.09);
  EXPECT_NEAR(entry.recomputed, 7.43, 0.005);
  EXPECT_EQ(entry.explanation, "follows when test 3 counts as 0 instead of the 5.32 printed in Table 7: then 8.09");
  const double recomputed[] = {21.45, 7.43, 3.61, 2.84, 6.81, 4.27, 5.53, 3.07};
  const char* factors[] = {"theta_F", "K_N", "eta_N", "K_T", "eta_T", "L_S", "N_E", "rotation"};
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(entry_of(check, "Table 8", std::string("repose_angle, ") + factors[i]).recomputed, recomputed[i], 0.0055);
  EXPECT_THAT(
      check.findings,
      Contains(HasSubstr(
          "Table 8, repose_angle: 7 of 8 range factors do not follow from Table 7; all do when test 3 counts as 0")));
}

TEST(ArticleCheck, TableTenLostADigit) {
  const ArticleCheck check = check_article();
  const CheckEntry& entry = entry_of(check, "Table 10", "sigma1_at_sigma3_5kPa, N_E");
  EXPECT_FALSE(entry.agrees);
  EXPECT_NEAR(entry.recomputed, 17.175, 1e-9);
  EXPECT_THAT(entry.explanation, HasSubstr("a digit is lost in print: 7.18 for 17.18"));
  EXPECT_EQ(entry.unit, "kPa");
}

TEST(ArticleCheck, TableFiveContradictsItselfAtTest26Only) {
  const ArticleCheck check = check_article();
  EXPECT_THAT(
      check.findings,
      Contains(HasSubstr("Table 5, test 26: density 1.68 and void ratio 0.79 contradict each other (2.93/rho - 1 = 0.74)")));
  for (const int test : {7, 8, 9, 17, 19}) {  // off by 0.01 in print, within the rounding of the density
    EXPECT_TRUE(entry_of(check, "Table 5", "void_ratio from bulk_density, test " + std::to_string(test)).agrees) << test;
  }
}

TEST(ArticleCheck, SaysWhatWasRestoredAndWhatLeansOnOneTest) {
  const ArticleCheck check = check_article();
  EXPECT_THAT(check.findings, Contains("56 of 64 range factors of Tables 4, 6, 8 and 10 follow from Tables 3, 5, 7 and 9"));
  EXPECT_THAT(check.findings, Contains(HasSubstr("Table 2 prints no K_N for test 5; 50000 N/m is the only level")));
  EXPECT_THAT(check.findings, Contains(HasSubstr("repose_angle: the effect of K_N leans on one test: without point 27")));
  EXPECT_THAT(check.findings, Contains(HasSubstr("repose_angle: the effect of eta_T leans on one test: without point 27")));
}

}  // namespace
}  // namespace regolab::analysis
