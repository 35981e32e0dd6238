// The article's data as compiled in, against sums and cells read off the printed page, and against the example design.
#include <gtest/gtest.h>

#include "scheduler/analysis/article.h"
#include "scheduler/analysis/article_tables.h"
#include "scheduler/design/array_quality.h"
#include "scheduler/design/design_file.h"
#include "support/diagnostics.h"

namespace regolab::analysis {
namespace {

TEST(ArticleData, HasThirtyTwoTestsInEveryTable) {
  for (const int table : {2, 3, 5, 7, 9}) {
    const auto rows = article_table(table);
    ASSERT_EQ(rows.size(), 33u) << table;
    for (std::size_t test = 1; test <= 32; ++test) {
      EXPECT_EQ(rows[test][0], std::to_string(test));
      EXPECT_EQ(rows[test].size(), rows[0].size());
    }
  }
}

TEST(ArticleData, CellsAsPrinted) {
  EXPECT_EQ(article_table(2)[5][2], "");  // the K_N that is not printed
  EXPECT_EQ(article_table(3)[14][1], "2.13");
  EXPECT_EQ(article_table(5)[26][2], "0.79");
  EXPECT_EQ(article_table(7)[3][1], "5.32");
  EXPECT_EQ(article_table(9)[16][4], "222.4");
  EXPECT_EQ(article_table(10)[3][7], "7.18");
}

TEST(ArticleData, OnlyOneStiffnessMakesTestFiveOrthogonal) {
  const ArticleDesign& design = article_design();
  EXPECT_EQ(design.restorations, 1);
  EXPECT_EQ(design.restored_level, "50000");
  const ArrayQuality quality = quality_of(std::vector<int>(8, 4), design.rows);
  EXPECT_EQ(quality.strength, 2);
  EXPECT_EQ(quality.error_degrees_of_freedom, 7);
}

TEST(ArticleData, TheExampleDesignIsTableTwo) {
  const Read<Design> design = read_design(
      {testing_support::read_file(REGOLAB_SOURCE "/client/examples/article-l32.yaml"), "article-l32.yaml", {}}, {});
  ASSERT_TRUE(design.ok());
  const ResultTable article = article_results();
  ASSERT_EQ(design.value->factors.size(), article.factors.size());
  for (std::size_t i = 0; i < article.factors.size(); ++i) {
    EXPECT_EQ(design.value->factors[i].name, article.factors[i].name);
    EXPECT_EQ(design.value->factors[i].unit, article.factors[i].unit);
    EXPECT_EQ(design.value->factors[i].labels, article.factors[i].levels);
  }
  for (std::size_t test = 0; test < 32; ++test)
    EXPECT_EQ(design.value->points[test].level, article.rows[test].level) << test + 1;
}

TEST(ArticleData, ValuesAreInSi) {
  const ResultTable table = article_results();
  EXPECT_NEAR(table.rows[0].value.at("bulk_density"), 1580, 1e-9);
  EXPECT_NEAR(table.rows[0].value.at("repose_angle"), 0.58032, 1e-5);
  EXPECT_NEAR(table.rows[31].value.at("sigma1_at_sigma3_10kPa"), 51000, 1e-9);
}

}  // namespace
}  // namespace regolab::analysis
