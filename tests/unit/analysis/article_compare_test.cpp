#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scheduler/analysis/article.h"

namespace regolab::analysis {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const CompareResponse& response_of(const ArticleComparison& comparison, const std::string& id) {
  return *std::ranges::find(comparison.responses, id, &CompareResponse::response);
}

TEST(CompareArticle, TheArticleAgreesWithItself) {
  const auto comparison = compare_article(article_results());
  ASSERT_TRUE(comparison.ok()) << comparison.error().text;
  ASSERT_EQ(comparison->responses.size(), 8u);
  for (const CompareResponse& response : comparison->responses) {
    EXPECT_EQ(response.tests_compared, 32);
    EXPECT_NEAR(response.correlation, 1, 1e-12);
    EXPECT_NEAR(response.mean_error, 0, 1e-12);
    EXPECT_NEAR(response.mean_absolute_relative_error, 0, 1e-12);
    EXPECT_EQ(response.leading_factors_ours, response.leading_factors_article);
  }
  EXPECT_THAT(response_of(*comparison, "contacts_per_particle").leading_factors_article, ElementsAre("theta_F", "N_E"));
  EXPECT_THAT(response_of(*comparison, "bulk_density").leading_factors_article, ElementsAre("N_E", "theta_F"));
}

TEST(CompareArticle, RowsAreMatchedByTheirValues) {
  ResultTable ours = article_results();
  std::ranges::reverse(ours.rows);
  for (std::size_t i = 0; i < ours.rows.size(); ++i) ours.rows[i].point = static_cast<int>(i) + 1;
  std::ranges::reverse(ours.factors[0].levels);  // other level order, other writing of the numbers
  for (TableRow& row : ours.rows) row.level[0] = 3 - row.level[0];
  ours.factors[1].levels = {"2.5e4", "5e4", "7.5e4", "1e5"};
  const auto comparison = compare_article(ours);
  ASSERT_TRUE(comparison.ok()) << comparison.error().text;
  EXPECT_NEAR(response_of(*comparison, "repose_angle").correlation, 1, 1e-12);
}

TEST(CompareArticle, BiasScatterAndSeedsAreReported) {
  ResultTable ours = article_results();
  const std::size_t n = ours.rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    TableRow second = ours.rows[i];
    ours.rows[i].value["bulk_density"] *= 1.04;
    second.value["bulk_density"] *= 1.06;
    second.seed = 2;
    ours.rows.push_back(second);
  }
  const auto comparison = compare_article(ours);
  const CompareResponse& density = response_of(*comparison, "bulk_density");
  EXPECT_EQ(density.unit, "g/cm3");
  EXPECT_NEAR(density.mean_absolute_relative_error, 0.05, 1e-12);
  EXPECT_NEAR(density.mean_error, 0.05 * 1.575, 1e-4);
  EXPECT_NEAR(density.correlation, 1, 1e-12);
  EXPECT_NEAR(*density.cells[0].ours_standard_error, 0.01 * 1.58, 1e-9);
  EXPECT_NEAR(density.cells[0].article, 1.58, 1e-12);
}

TEST(CompareArticle, MissingCellsSayWhy) {
  ResultTable ours = article_results();
  ours.rows[6].value.erase("repose_angle");
  ours.rows[6].missing["repose_angle"] = "not settled (the time limit came first)";
  ours.rows.pop_back();
  const auto comparison = compare_article(ours);
  const CompareResponse& repose = response_of(*comparison, "repose_angle");
  EXPECT_EQ(repose.tests_compared, 30);
  EXPECT_FALSE(repose.cells[6].ours);
  EXPECT_EQ(repose.cells[6].missing, "point 7 seed 0: not settled (the time limit came first)");
  EXPECT_EQ(repose.cells[31].missing, "not in this experiment");
  EXPECT_THAT(comparison->notes, Contains("the experiment holds 31 of the article's 32 tests"));
}

TEST(CompareArticle, ResponsesNotMeasuredAreNoted) {
  ResultTable ours = article_results();
  ours.responses.resize(3);
  const auto comparison = compare_article(ours);
  EXPECT_EQ(comparison->responses.size(), 3u);
  EXPECT_THAT(comparison->notes, Contains("repose_angle was not measured in this experiment"));
}

std::string refusal(const ResultTable& table) {
  const auto comparison = compare_article(table);
  return comparison.ok() ? "compared" : comparison.error().text;
}

TEST(CompareArticle, OtherDesignsAreRefused) {
  ResultTable other_level = article_results();
  other_level.factors[0].levels[1] = "25";
  EXPECT_THAT(refusal(other_level), HasSubstr("is none of the article's 32 tests (theta_F 25, K_N 50000"));
  ResultTable no_rotation = article_results();
  no_rotation.factors.pop_back();
  EXPECT_THAT(refusal(no_rotation), HasSubstr("experiment does not say rotation"));
  ResultTable earth = article_results();
  earth.fixed["gravity"] = "9.8 m/s2";
  EXPECT_THAT(refusal(earth), HasSubstr("experiment has gravity 9.8 m/s2 (the article has 1.63 m/s2)"));
  ResultTable ratio = article_results();
  ratio.fixed["damping_unit"] = "ratio";
  EXPECT_THAT(refusal(ratio), HasSubstr("damping_unit ratio"));
  ResultTable twice = article_results();
  twice.rows[1].level = twice.rows[0].level;
  EXPECT_THAT(refusal(twice), HasSubstr("points 1 and 2 are both the article's test 1"));
}

TEST(CompareArticle, AFixedParameterCountsAsSaid) {  // the tests with rotation xz only
  ResultTable ours = article_results();
  std::erase_if(ours.rows, [](const TableRow& row) { return row.level[7] != 3; });
  for (TableRow& row : ours.rows) row.level.pop_back();
  ours.factors.pop_back();
  ours.fixed["rotation"] = "xz";
  const auto comparison = compare_article(ours);
  ASSERT_TRUE(comparison.ok()) << comparison.error().text;
  EXPECT_EQ(comparison->responses[0].tests_compared, 8);
}

}  // namespace
}  // namespace regolab::analysis
