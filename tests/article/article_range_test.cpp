// Range analysis and its statistics on the article's data, against figures worked out independently.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scheduler/analysis/article.h"
#include "scheduler/analysis/range.h"

namespace regolab::analysis {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

ResponseAnalysis analyse(const std::string& response) { return *analyse_range(article_results(), response); }

const FactorAnalysis& factor(const ResponseAnalysis& analysis, const std::string& name) {
  return *std::ranges::find(analysis.factors, name, &FactorAnalysis::name);
}

TEST(ArticleRange, ResidualScatterWithSevenDegreesOfFreedom) {
  const std::pair<const char*, double> expected[] = {{"contacts_per_particle", 0.1948},
                                                     {"bulk_density", 0.02449},
                                                     {"void_ratio", 0.02847},
                                                     {"repose_angle", 5.08},
                                                     {"sigma1_at_sigma3_1.25kPa", 15.4},
                                                     {"sigma1_at_sigma3_2.5kPa", 12.0},
                                                     {"sigma1_at_sigma3_5kPa", 20.2},
                                                     {"sigma1_at_sigma3_10kPa", 33.1}};
  for (const auto& [response, sd] : expected) {
    const ResponseAnalysis analysis = analyse(response);
    EXPECT_EQ(analysis.error_degrees_of_freedom, 7) << response;
    EXPECT_NEAR(analysis.residual_standard_deviation, sd, 0.005 * sd) << response;
    EXPECT_THAT(analysis.missing, ::testing::IsEmpty());
  }
}

TEST(ArticleRange, OnlyFrictionMattersForRepose) {
  const ResponseAnalysis analysis = analyse("repose_angle");
  EXPECT_NEAR(*factor(analysis, "theta_F").f, 31.6, 0.05);
  EXPECT_NEAR(*factor(analysis, "K_N").f, 3.6, 0.05);
  EXPECT_NEAR(*factor(analysis, "eta_T").f, 3.0, 0.05);
  EXPECT_NEAR(*factor(analysis, "N_E").f, 2.2, 0.06);
  for (const FactorAnalysis& f : analysis.factors) EXPECT_EQ(*f.p < 0.05, f.name == "theta_F") << f.name;
  EXPECT_TRUE(factor(analysis, "K_N").fragile);
  EXPECT_TRUE(factor(analysis, "eta_T").fragile);
  EXPECT_FALSE(factor(analysis, "theta_F").fragile);
  EXPECT_EQ(factor(analysis, "K_N").leaning_on_point, 27);
}

double plain_range(const FactorAnalysis& factor) {
  double low = INFINITY, high = -INFINITY;
  for (const LevelStatistics& level : factor.levels) {
    low = std::min(low, level.sum / level.runs);
    high = std::max(high, level.sum / level.runs);
  }
  return high - low;
}

/// Plain level means of the other 30 tests are confounded; the refitted model says how much of a range is left.
TEST(ArticleRange, WithoutTestsThreeAndTwentySevenReposeHasOneEffect) {
  ResultTable table = article_results();
  table.rows[2].value.erase("repose_angle");
  table.rows[26].value.erase("repose_angle");
  const ResponseAnalysis analysis = *analyse_range(table, "repose_angle");
  EXPECT_EQ(analysis.runs_used, 30);
  EXPECT_EQ(analysis.error_degrees_of_freedom, 5);
  EXPECT_NEAR(plain_range(factor(analysis, "K_N")), 2.8, 0.05);
  EXPECT_NEAR(plain_range(factor(analysis, "N_E")), 2.7, 0.05);
  EXPECT_NEAR(plain_range(factor(analysis, "eta_T")), 1.5, 0.05);
  EXPECT_NEAR(plain_range(factor(analysis, "theta_F")), 18.9, 0.05);
  EXPECT_NEAR(factor(analysis, "K_N").range, 3.15, 0.005);
  EXPECT_NEAR(factor(analysis, "N_E").range, 4.56, 0.005);
  EXPECT_NEAR(factor(analysis, "eta_T").range, 2.53, 0.005);
  for (const FactorAnalysis& f : analysis.factors) {
    if (f.name == "theta_F") continue;
    EXPECT_LE(f.range, factor(analysis, "theta_F").range / 4) << f.name;
  }
}

TEST(ArticleRange, FrictionAndShapeLeadContactsAndDensity) {
  for (const char* response : {"contacts_per_particle", "bulk_density", "void_ratio"}) {
    const ResponseAnalysis analysis = analyse(response);
    for (const FactorAnalysis& f : analysis.factors) {
      const bool leads = f.name == "theta_F" || f.name == "N_E";
      EXPECT_EQ(*f.p < 0.05, leads) << response << " " << f.name;
      EXPECT_EQ(f.rank <= 2, leads) << response << " " << f.name;
      if (leads) {
        EXPECT_FALSE(f.fragile) << response << " " << f.name;
      }
    }
  }
  std::vector<double> friction, shape;
  const ResponseAnalysis density = analyse("bulk_density");
  for (const LevelStatistics& level : factor(density, "theta_F").levels) friction.push_back(level.mean);
  for (const LevelStatistics& level : factor(density, "N_E").levels) shape.push_back(level.mean);
  EXPECT_THAT(friction, Pointwise(DoubleNear(0.0051), {1.72, 1.56, 1.52, 1.49}));
  EXPECT_THAT(shape, Pointwise(DoubleNear(0.0051), {1.70, 1.56, 1.42, 1.61}));
}

TEST(ArticleRange, FrictionAndSizeLeadTheStress) {
  for (const char* response :
       {"sigma1_at_sigma3_1.25kPa", "sigma1_at_sigma3_2.5kPa", "sigma1_at_sigma3_5kPa", "sigma1_at_sigma3_10kPa"}) {
    const ResponseAnalysis analysis = analyse(response);
    for (const FactorAnalysis& f : analysis.factors)
      EXPECT_EQ(*f.p < 0.05, f.name == "theta_F" || f.name == "L_S") << response << " " << f.name;
  }
  EXPECT_NEAR(*factor(analyse("sigma1_at_sigma3_2.5kPa"), "theta_F").f, 16.4, 0.05);
  EXPECT_NEAR(*factor(analyse("sigma1_at_sigma3_2.5kPa"), "L_S").f, 17.6, 0.05);
  const ResponseAnalysis analysis = analyse("sigma1_at_sigma3_10kPa");
  std::vector<double> k_t;
  for (const LevelStatistics& level : factor(analysis, "K_T").levels) k_t.push_back(level.mean);
  EXPECT_THAT(k_t, Pointwise(DoubleNear(0.051), {70.0, 79.3, 73.8, 102.2}));  // the article's text puts the maximum at 5e4
}

}  // namespace
}  // namespace regolab::analysis
