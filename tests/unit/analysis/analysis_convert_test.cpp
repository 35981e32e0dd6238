#include "scheduler/rpc/analysis_convert.h"

#include <gtest/gtest.h>

namespace regolab {
namespace {

TEST(AnalysisConvert, RangeKeepsEveryNumber) {
  const auto analyses = analysis::analyse_ranges(analysis::article_results(), "");
  ASSERT_TRUE(analyses.ok());
  const v1::RangeReply reply = to_proto("E1", *analyses);
  EXPECT_EQ(reply.experiment(), "E1");
  ASSERT_EQ(reply.responses_size(), static_cast<int>(analyses->size()));
  const analysis::ResponseAnalysis& in = (*analyses)[3];
  const v1::ResponseAnalysis& out = reply.responses(3);
  EXPECT_EQ(out.response(), "repose_angle");
  EXPECT_EQ(out.unit(), "deg");
  EXPECT_EQ(out.mean(), in.mean);
  EXPECT_EQ(out.residual_standard_deviation(), in.residual_standard_deviation);
  EXPECT_EQ(out.error_degrees_of_freedom(), 7);
  EXPECT_FALSE(out.has_seed_standard_deviation());
  const analysis::FactorAnalysis& factor = in.factors[1];
  const v1::FactorAnalysis& shown = out.factors(1);
  EXPECT_EQ(shown.name(), "K_N");
  EXPECT_EQ(shown.unit(), "N/m");
  EXPECT_EQ(shown.range(), factor.range);
  EXPECT_EQ(shown.f(), *factor.f);
  EXPECT_EQ(shown.p(), *factor.p);
  EXPECT_EQ(shown.fragile(), factor.fragile);
  EXPECT_EQ(shown.fragile_why(), factor.fragile_why);
  EXPECT_EQ(shown.leaning_on_point(), factor.leaning_on_point);
  EXPECT_EQ(shown.levels(2).label(), "75000");
  EXPECT_EQ(shown.levels(2).mean(), factor.levels[2].mean);
  EXPECT_EQ(shown.levels(2).half_width_95(), *factor.levels[2].half_width_95);
  EXPECT_FALSE(shown.has_range_standard_error());
}

TEST(AnalysisConvert, ArticleRepliesAreComplete) {
  const analysis::ArticleCheck check = analysis::check_article();
  const v1::CheckArticleReply reply = to_proto(check);
  ASSERT_EQ(reply.entries_size(), static_cast<int>(check.entries.size()));
  EXPECT_EQ(reply.findings_size(), static_cast<int>(check.findings.size()));
  EXPECT_EQ(reply.entries(0).entry(), check.entries[0].entry);
  const auto comparison = analysis::compare_article(analysis::article_results());
  const v1::CompareArticleReply compared = to_proto("E1", *comparison);
  EXPECT_EQ(compared.responses(0).cells_size(), 32);
  EXPECT_EQ(compared.responses(0).cells(4).article(), 2.86);
  EXPECT_EQ(compared.responses(0).cells(4).ours(), 2.86);
  EXPECT_FALSE(compared.responses(0).cells(4).has_ours_standard_error());
  EXPECT_EQ(compared.responses(0).leading_factors_ours(0), "theta_F");
}

TEST(AnalysisConvert, ResultsKeepValuesAndReasons) {
  ResultTable table = analysis::article_results();
  table.rows[2].missing["repose_angle"] = "pending";
  const v1::ResultsReply reply = to_proto(table, "study");
  EXPECT_EQ(reply.name(), "study");
  EXPECT_EQ(reply.rows(2).missing().at("repose_angle"), "pending");
  EXPECT_EQ(reply.rows(31).value_si().at("bulk_density"), table.rows[31].value.at("bulk_density"));
  EXPECT_EQ(reply.rows(31).level(0), 3);
  EXPECT_EQ(reply.factors(6).levels(3), "mixture");
  EXPECT_EQ(reply.responses(3).unit_si(), "rad");
}

TEST(AnalysisConvert, DiagnosticAndSummary) {
  const v1::Diagnostic diagnostic = to_proto(Diagnostic{"f.yaml", 3, 7, "problem (why) remedy", "line"});
  EXPECT_EQ(diagnostic.file(), "f.yaml");
  EXPECT_EQ(diagnostic.line(), 3u);
  EXPECT_EQ(diagnostic.column(), 7u);
  EXPECT_EQ(diagnostic.source_line(), "line");
  Design design;
  design.name = "study";
  design.array = "L9 (3^4)";
  design.quality = {.strength = 2, .balanced = true, .error_degrees_of_freedom = 4};
  design.factors = {{.name = "N_E", .unit = "1", .labels = {"2", "4"}, .column = 2}};
  design.seeds = {1, 2};
  design.repose = true;
  const v1::DesignSummary summary = to_proto(design);
  EXPECT_EQ(summary.strength(), 2u);
  EXPECT_TRUE(summary.balanced());
  EXPECT_EQ(summary.error_degrees_of_freedom(), 4);
  EXPECT_EQ(summary.factor_columns(0), "N_E: 2 levels, column 2");
  EXPECT_EQ(summary.tests_size(), 4);
  EXPECT_EQ(summary.seeds(), 2u);
}

}  // namespace
}  // namespace regolab
