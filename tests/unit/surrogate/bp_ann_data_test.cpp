// What a table must have to be learnt from, and how it is normalised.
#include "scheduler/surrogate/bp_ann_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scheduler/analysis/article.h"

namespace regolab::surrogate {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string why(const Result<AnnData>& data) { return data.ok() ? "trained" : data.error().text; }

TEST(AnnData, NormalisesTestTwelveAsTableElevenSays) {
  const auto data = ann_data(article_training_table(), 3);
  ASSERT_TRUE(data.ok()) << data.error().text;
  EXPECT_THAT(data->inputs, ElementsAre("theta_F", "K_N", "eta_N", "K_T", "eta_T", "L_S", "N_E=2", "N_E=4", "N_E=6",
                                        "N_E=mixture", "sigma3"));
  ASSERT_EQ(data->x.rows(), 128);
  const auto row = std::ranges::find(data->test, 12) - data->test.begin();  // 40 deg, 2.5e4, 0.25, 2.5e4, 0.25, 0.5 cm, 2
  const std::vector<double> expected{40.0 / 60, 0.25, 0.25, 0.25, 0.25, 0.25, 1, 0, 0, 0, 0.125};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_DOUBLE_EQ(data->x(row, static_cast<Eigen::Index>(i)), expected[i]);
  EXPECT_NEAR(data->y(row, 0), 52.9 / 250, 1e-12);
}

TEST(AnnData, TheMixtureIsAKindOfItsOwn) {
  const auto data = ann_data(article_training_table(), 1);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(data->x.row(1).tail(4), Eigen::RowVector4d(0, 0, 0, 1));  // test 2
}

TEST(AnnData, VoidRatiosAreRecomputedFromTheDensity) {
  const auto ours = ann_data(article_training_table(), 1);
  const auto printed = ann_data(analysis::article_results(), 1);
  ASSERT_TRUE(ours.ok() && printed.ok());
  EXPECT_NEAR(1.5 * printed->y(25, 2), 0.79, 1e-12);
  EXPECT_NEAR(1.5 * ours->y(25, 2), 2.93 / 1.68 - 1, 1e-12);
  for (int test = 0; test < 32; ++test) {
    if (test == 25) continue;
    EXPECT_NEAR(1.5 * ours->y(test, 2), 1.5 * printed->y(test, 2), 0.016) << test + 1;
  }
}

TEST(AnnData, AveragesSeeds) {
  ResultTable table = article_training_table();
  TableRow twin = table.rows.front();
  twin.seed = 1;
  table.rows.front().value["contacts_per_particle"] = 2;
  twin.value["contacts_per_particle"] = 3;
  table.rows.push_back(twin);
  const auto data = ann_data(table, 1);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(data->x.rows(), 32);
  EXPECT_DOUBLE_EQ(data->y(0, 0), 0.25);
}

TEST(AnnData, LeavesOutWhatIsMissing) {
  ResultTable table = article_training_table();
  table.rows[4].value.erase("bulk_density");
  table.rows[6].value.erase("sigma1_at_sigma3_5kPa");
  EXPECT_EQ(ann_data(table, 1)->x.rows(), 31);
  EXPECT_EQ(ann_data(table, 3)->x.rows(), 127);
}

TEST(AnnData, NamesAFactorThatIsNotThere) {
  ResultTable table = article_training_table();
  table.factors[1].name = "K_M";
  EXPECT_THAT(why(ann_data(table, 2)), HasSubstr("does not vary K_N (it is not among the factors"));
  table.fixed["K_N"] = "100000 N/m";
  EXPECT_THAT(why(ann_data(table, 2)), HasSubstr("it is fixed at 100000 N/m"));
  EXPECT_TRUE(ann_data(table, 1).ok());
}

TEST(AnnData, NamesAResponseThatIsNotMeasured) {
  ResultTable table = article_training_table();
  std::erase_if(table.responses, [](const TableResponse& r) { return r.id != "bulk_density"; });
  EXPECT_THAT(why(ann_data(table, 1)), HasSubstr("has no contacts_per_particle"));
  EXPECT_THAT(why(ann_data(table, 2)), HasSubstr("name an experiment with the test `repose`"));
  EXPECT_THAT(why(ann_data(table, 3)), HasSubstr("has no sigma1"));
}

TEST(AnnData, RefusesTooFewTestsNanAndUnknownKinds) {
  ResultTable table = article_training_table();
  table.rows.resize(11);
  EXPECT_THAT(why(ann_data(table, 1)), HasSubstr("has only 11 tests"));
  table = article_training_table();
  table.rows[2].value["repose_angle"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(why(ann_data(table, 2)), HasSubstr("point 3 seed 0 of experiment article: repose_angle is not a number"));
  EXPECT_EQ(ann_data(table, 2).error().code, Code::kDataLoss);
  table = article_training_table();
  table.factors[6].levels[3] = "12";
  EXPECT_THAT(why(ann_data(table, 1)), HasSubstr("N_E is `12` (2, 4, 6 or mixture is wanted)"));
  table = article_training_table();
  table.factors[0].levels[0] = "nan";
  EXPECT_THAT(why(ann_data(table, 1)), HasSubstr("theta_F is `nan` (a number is wanted)"));
  EXPECT_EQ(ann_data(table, 4).error().code, Code::kInvalidArgument);
}

}  // namespace
}  // namespace regolab::surrogate
