#include "scheduler/surrogate/invert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/surrogate/materials.h"

namespace regolab::surrogate {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::study;

const Model& trained() {
  static const Model model = *train("made-up", *dataset_of({{study(), {}}}));
  return model;
}

Read<Question> read(const std::string& text) { return read_target("target.yaml", text, trained()); }

TEST(TargetFile, ReadsUnitsSharesAndFrictionAngles) {
  const auto question = read("targets:\n  bulk_density: {value: 1.6 g/cm3, tolerance: 1 %}\n  friction_angle: {sigma3: 5 kPa, value: 20 degree, tolerance: 1 degree}\n"
                             "fixed: {N_E: 2}\nfree: {theta_F: [10 degree, 40 degree]}\n");
  ASSERT_TRUE(question.ok()) << question.diagnostics.front().text;
  EXPECT_DOUBLE_EQ(question.value->targets[0].value, 1600);
  EXPECT_DOUBLE_EQ(question.value->targets[0].tolerance, 16);
  EXPECT_EQ(question.value->targets[1].response, "sigma1_at_sigma3_5kPa");
  EXPECT_NEAR(question.value->targets[1].value, 5e3 * (1 + std::sin(20 * kDegree)) / (1 - std::sin(20 * kDegree)), 20);
  EXPECT_NEAR(question.value->spans[0].low, 10 * kDegree, 1e-12);
}

struct Bad {
  const char* text;
  const char* says;
};
class BadTarget : public testing::TestWithParam<Bad> {};

TEST_P(BadTarget, IsToldWithItsPlace) {
  const auto question = read(GetParam().text);
  ASSERT_FALSE(question.ok());
  EXPECT_THAT(question.diagnostics, Contains(Field(&Diagnostic::text, HasSubstr(GetParam().says))));
  for (const Diagnostic& d : question.diagnostics) EXPECT_GT(d.line, 0) << d.text;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadTarget,
    testing::Values(Bad{"name: x\n", "missing"}, Bad{"targets: {densty: {value: 1, tolerance: 1}}\n", "unknown property 'densty'"},
                    Bad{"targets: {bulk_density: {value: 1.6, tolerance: 1 %}}\n", "has no unit"},
                    Bad{"targets: {bulk_density: {value: 1.6 kPa, tolerance: 1 %}}\n", "expected"},
                    Bad{"targets: {bulk_density: {value: 1.6 g/cm3, tolerance: -1 %}}\n", "must be above 0"},
                    Bad{"targets: {bulk_density: {value: nan g/cm3, tolerance: 1 %}}\n", "must be a number"},
                    Bad{"targets: {sigma1: {sigma3: 50 kPa, value: 90 kPa, tolerance: 5 %}}\n", "trained on other confining stresses"},
                    Bad{"targets: {sigma1: [{sigma3: 5 kPa, value: 9 kPa, tolerance: 1 %}, {sigma3: 5 kPa, value: 15 kPa, tolerance: 1 %}]}\n", "contradict each other"},
                    Bad{"targets: {bulk_density: {value: 1.6 g/cm3, tolerance: 1 %}}\nfixed: {theta_F: 80 degree}\n", "outside the model's data"},
                    Bad{"targets: {bulk_density: {value: 1.6 g/cm3, tolerance: 1 %}}\nfixed: {K_N: 5e4 N/m}\n", "unknown parameter 'K_N'"},
                    Bad{"targets: {bulk_density: {value: 1.6 g/cm3, tolerance: 1 %}}\nfree: {theta_F: [40 degree, 10 degree]}\n", "[low, high]"},
                    Bad{"targets: []\n", "must be a map"}, Bad{"\xff\xfe", "not"}));

TEST(Invert, FindsMaterialsThatAreThere) {
  const auto question = read("targets:\n  bulk_density: {value: 1.58 g/cm3, tolerance: 0.5 %}\n  sigma1: {sigma3: 10 kPa, value: 21 kPa, tolerance: 2 %}\n");
  ASSERT_TRUE(question.ok());
  const Inversion found = invert(trained(), *question.value, 4);
  ASSERT_FALSE(found.candidates.empty());
  const Candidate& best = found.candidates.front();
  EXPECT_LT(best.miss, 1);
  const double degrees = best.x[0] / kDegree;
  EXPECT_NEAR(testing_support::true_sigma1(1e4, degrees), 21e3, 0.02 * 21e3);
  EXPECT_NEAR(testing_support::true_density(degrees, 100 * best.x[1], best.x[2] == 0 ? 0 : 1), 1580, 8);
  EXPECT_GT(found.fitting, 0);
  EXPECT_LT(found.freedom[0].high - found.freedom[0].low, 15 * kDegree) << "the stress leaves little of the friction open";
  EXPECT_GT(found.freedom[1].high - found.freedom[1].low, 0.005) << "it says nothing of the size";
}

TEST(Invert, SaysWhatIsOutOfReachAndGivesTheNearest) {
  const auto question = read("targets:\n  bulk_density: {value: 2.5 g/cm3, tolerance: 1 %}\n");
  ASSERT_TRUE(question.ok());
  const Inversion found = invert(trained(), *question.value, 3);
  EXPECT_THAT(found.notes, Contains(HasSubstr("bulk_density 2.5 g/cm3 is out of reach")));
  EXPECT_EQ(found.fitting, 0);
  EXPECT_LT(found.candidates.front().x[0], 10 * kDegree) << "the densest material there is";
}

TEST(Invert, TogetherOutOfReachIsToldToo) {
  const auto question = read("targets:\n  bulk_density: {value: 1.7 g/cm3, tolerance: 0.5 %}\n  sigma1: {sigma3: 10 kPa, value: 32 kPa, tolerance: 2 %}\n");
  ASSERT_TRUE(question.ok());
  EXPECT_THAT(invert(trained(), *question.value, 3).notes, Contains(HasSubstr("no material of the box meets all targets together")));
}

TEST(Invert, NewRunsAreLearned) {
  Source more{study(1, 0), {}};
  for (TableRow& row : more.table.rows) row.value["bulk_density"] += 40;  // DEM says otherwise, everywhere
  const auto taught = with_rows(trained(), {more});
  ASSERT_TRUE(taught.ok());
  const auto x = trained().data.rows[10].x;
  EXPECT_GT(taught->predict(x)[0].value, trained().predict(x)[0].value + 5);
}

}  // namespace
}  // namespace regolab::surrogate
