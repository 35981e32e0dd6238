#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/views/range_text.h"
#include "client/views/results_text.h"
#include "client/views/study_text.h"
#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Views, SummaryShowsWhatIsWorthKnowingBeforeItRuns) {
  const std::string text = summary_text(sample_summary());
  EXPECT_THAT(text, HasSubstr("L4 (2^3): 4 points x 1 seed, strength 2 (orthogonal), balanced, 1 error degrees of freedom"));
  EXPECT_THAT(text, HasSubstr("12 stages, 3 stored already, 6 DEM runs to do"));
  EXPECT_THAT(text, HasSubstr("theta_F: 2 levels, column 1\n         N_E: 2 levels, column 2"));
}

TEST(Views, RangeMatrixMarksSignificantAndFragileFactorsAndSaysWhatIsMissing) {
  const std::string text = range_matrix_text(sample_range());
  EXPECT_THAT(text, HasSubstr("theta_F          0.250 ±0.020*   0.250 ±0.020*"));
  EXPECT_THAT(text, HasSubstr("0.080 ±0.020 !"));
  EXPECT_THAT(text, HasSubstr("missing cells are left out, not filled\n  contacts, density: 1 x not settled (40 s)\n"));
}

TEST(Views, RangeDetailRanksFactorsAndExplainsFragility) {
  const std::string text = range_detail_text(sample_range().responses(1));
  EXPECT_THAT(text, HasSubstr("bulk_density (g/cm3): mean 1.575, 4 runs, residual spread 0.022 (1 degrees of freedom), "
                              "spread between seeds 0.010"));
  EXPECT_LT(text.find("theta_F (deg)"), text.find("N_E"));
  EXPECT_THAT(text, HasSubstr("<0.001"));
  EXPECT_THAT(text, HasSubstr("0.1: 1.750 (3.50)"));
  EXPECT_THAT(text, HasSubstr("! N_E is fragile: without point 3 it is not significant"));
}

TEST(Views, ResultsShowMissingCellsWithTheirReason) {
  const std::string text = results_text(sample_results(), false);
  EXPECT_THAT(text, HasSubstr("    1     1      0.1        2     3.100    1.650   10.00\n"));
  EXPECT_THAT(text, HasSubstr("    4     1       40  mixture     3.400    1.500       -\n"));
  EXPECT_THAT(text, HasSubstr("missing (-)\n  point 4 seed 1: repose: not settled (40 s of 40 s)"));
}

TEST(Views, CheckCountsPerTableAndExplainsEachDisagreementOnce) {
  pb::CheckArticleReply check;
  for (int i = 0; i < 4; ++i) {
    auto* entry = check.add_entries();
    entry->set_table(i < 2 ? "Table 4" : "Table 8");
    entry->set_entry("range of K_N " + std::to_string(i));
    entry->set_unit("deg");
    entry->set_printed(7.43);
    entry->set_recomputed(i < 2 ? 7.43 : 6.1);
    entry->set_agrees(i < 2);
    if (i >= 2) entry->set_explanation("needs run 3 to be 0 deg");
  }
  check.add_findings("Table 8 does not follow");
  const std::string text = check_text(check, false);
  EXPECT_THAT(text, HasSubstr("Table 4  2 of 2 entries follow from the data"));
  EXPECT_THAT(text, HasSubstr("Table 8  0 of 2 entries follow from the data"));
  EXPECT_THAT(text, HasSubstr("differs [1]"));
  EXPECT_THAT(text, Not(HasSubstr("[2]")));
  EXPECT_THAT(text, Not(HasSubstr("agrees")));
  EXPECT_THAT(check_text(check, true), HasSubstr("agrees"));
}

TEST(Views, ComparisonPutsBothColumnsSideBySide) {
  pb::CompareArticleReply comparison;
  auto* response = comparison.add_responses();
  response->set_response("bulk_density");
  response->set_unit("g/cm3");
  response->set_tests_compared(1);
  response->set_correlation(0.97);
  response->set_mean_error(-0.031);
  response->set_mean_absolute_relative_error(0.042);
  response->add_leading_factors_article("theta_F");
  response->add_leading_factors_ours("N_E");
  auto* cell = response->add_cells();
  cell->set_test(1);
  cell->set_article(1.64);
  cell->set_ours(1.61);
  cell->set_ours_standard_error(0.012);
  cell = response->add_cells();
  cell->set_test(2);
  cell->set_article(1.5);
  cell->set_missing("not settled");
  const std::string text = comparison_text(comparison);
  EXPECT_THAT(text, HasSubstr("density (g/cm3)      1        0.970      -0.031           4.2"));
  EXPECT_THAT(text, HasSubstr("1.640  1.610 ±0.012"));
  EXPECT_THAT(text, HasSubstr("1.500  -"));
  EXPECT_THAT(text, HasSubstr("  density: 1 x not settled (tests 2)\n"));
}

TEST(Views, ListIsOldestFirst) {
  pb::ListReply list;
  for (const char* id : {"E2", "E1"}) {
    auto* experiment = list.add_experiments();
    *experiment = sample_status("done");
    experiment->set_experiment(id);
    experiment->set_created_unix_ms(id[1] == '1' ? 1000 : 2000);
  }
  const std::string text = list_text(list);
  EXPECT_LT(text.find("E1"), text.find("E2"));
}

}  // namespace
}  // namespace regolab::client
