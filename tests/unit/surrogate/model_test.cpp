#include "scheduler/surrogate/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/surrogate/material.h"
#include "unit/surrogate/materials.h"

namespace regolab::surrogate {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_support::study;
using testing_support::true_density;
using testing_support::true_sigma1;

const Model& trained() {
  static const Model model = *train("made-up", *dataset_of({{study(), {}}}));
  return model;
}

std::vector<double> material(const std::string& theta, const std::string& size, const std::string& shape) {
  const auto read = read_material(trained(), {{"theta_F", theta}, {"L_S", size}, {"N_E", shape}});
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().text);
  return read->x;
}

TEST(Dataset, AveragesSeedsAndEncodesChoices) {
  const auto data = dataset_of({{study(3, 0), {}}});
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(data->rows.size(), 56U);
  EXPECT_EQ(data->rows[0].mean.at("bulk_density").seeds, 3);
  EXPECT_NEAR(data->rows[0].mean.at("bulk_density").value, true_density(1, 0.5, 0), 1e-9);
  EXPECT_NEAR(data->columns[0].low, 1 * kDegree, 1e-12);
  EXPECT_EQ(inputs_of(data->columns, data->rows[1].x).scaled.size(), 2 + 4) << "two numbers and one-hot N_E";
}

TEST(Dataset, JoinsExperimentsByWhatTheyVaryAndMergesOneMaterial) {
  ResultTable earth = study();
  earth.fixed["gravity"] = "9.8 m/s2";
  const auto data = dataset_of({{study(), {}}, {earth, {}}, {study(), {}}});
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(data->columns.back().name, "gravity");
  EXPECT_EQ(data->rows.size(), 2 * 56U) << "the third is the first again";
  EXPECT_EQ(data->rows[0].mean.at("bulk_density").seeds, 4);
}

TEST(Dataset, RefusesWhatItCannotLearnFrom) {
  ResultTable few = study();
  few.rows.resize(10);
  EXPECT_THAT(dataset_of({{few, {}}}).error().text, HasSubstr("only 5 points have numbers"));
  ResultTable damaged = study();
  damaged.rows[3].value["bulk_density"] = NAN;
  EXPECT_THAT(dataset_of({{damaged, {}}}).error().text, HasSubstr("point 2 seed 2: bulk_density is not a finite number"));
  ResultTable silent = study(), varied = study();
  silent.factors.erase(silent.factors.begin() + 1);
  for (TableRow& row : silent.rows) row.level.erase(row.level.begin() + 1);
  EXPECT_THAT(dataset_of({{varied, {}}, {silent, {}}}).error().text, HasSubstr("does not say its L_S"));
  EXPECT_THAT(dataset_of({}).error().text, HasSubstr("no experiment to learn from"));
}

TEST(Model, PredictsMaterialsItHasNotSeen) {
  for (const double degrees : {5.0, 15.0, 33.0, 57.0}) {
    const auto x = material(std::to_string(degrees) + " deg", "1.2 cm", "6");
    const auto estimates = trained().predict(x);
    const auto density = std::ranges::find(estimates, "bulk_density", &Estimate::id);
    ASSERT_NE(density, estimates.end());
    EXPECT_NEAR(density->value, true_density(degrees, 1.2, 1), 4);
    EXPECT_LT(density->low, density->mean_low);
    EXPECT_THAT(trained().outside(x), IsEmpty());
  }
  EXPECT_GT(trained().find("bulk_density")->skill.r, 0.99);
  EXPECT_GE(trained().find("bulk_density")->skill.coverage, 0.85);
}

TEST(Model, StressBetweenTheTestsFollowsTheirLogarithms) {
  const auto x = material("30 deg", "1 cm", "2");
  const auto at7 = trained().sigma1_at(x, 7e3);
  ASSERT_TRUE(at7);
  EXPECT_NEAR(at7->value, true_sigma1(7e3, 30), 0.01 * true_sigma1(7e3, 30));
  EXPECT_FALSE(trained().sigma1_at(x, 2e3)) << "below the data";
  EXPECT_FALSE(trained().sigma1_at(x, 11e3)) << "above the data";
}

TEST(Model, SaysWhatLiesOutsideTheData) {
  EXPECT_THAT(trained().outside(material("75 deg", "1 cm", "4")),
              ElementsAre(HasSubstr("theta_F = 75 deg (the data end at 60)"), HasSubstr("N_E = 4 (the data have none)")));
}

TEST(Model, MissingUnknownAndUnreadableParametersAreToldTogether) {
  const auto read = read_material(trained(), {{"theta", "3 deg"}, {"L_S", "1 N"}, {"particle_density", "3 g/cm3"}});
  ASSERT_FALSE(read.ok());
  for (const char* part : {"unknown parameter 'theta'", "missing theta_F", "L_S", "missing N_E"}) EXPECT_THAT(read.error().text, HasSubstr(part));
}

TEST(Model, ComesBackFromItsFileBitForBit) {
  const std::string text = to_json(trained());
  const auto back = model_from_json(text);
  ASSERT_TRUE(back.ok()) << back.error().text;
  EXPECT_EQ(back->id, trained().id);
  EXPECT_EQ(to_json(*back), text);
  const auto x = material("22 deg", "1.7 cm", "2");
  EXPECT_EQ(back->predict(x)[0].value, trained().predict(x)[0].value);
}

TEST(Model, TrainedAgainIsTheSameModel) { EXPECT_EQ(to_json(*train("made-up", *dataset_of({{study(), {}}}))), to_json(trained())); }

TEST(Model, DamagedAndForeignFilesAreRefused) {
  std::string text = to_json(trained());
  EXPECT_THAT(model_from_json(text.substr(0, text.size() / 2)).error().text, HasSubstr("cannot be read"));
  EXPECT_THAT(model_from_json("{\"format\": \"other\"}").error().text, HasSubstr("not a regolab model"));
  const auto at = text.find("\"physics_version\": ");
  text.insert(at + 19, "9");
  const auto refused = model_from_json(text);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Code::kFailedPrecondition);
  EXPECT_THAT(refused.error().text, HasSubstr("train it again"));
}

/// The model that comes with the program is what training on its own data gives.
TEST(Model, TheShippedOneCanBeRecomputed) {
  const Model* shipped = shipped_model();
  ASSERT_NE(shipped, nullptr);
  const ResponseModel* density = shipped->find("bulk_density");
  ASSERT_NE(density, nullptr);
  const GaussianProcess& process = *density->processes.front();
  const Hyperparameters again = fit_hyperparameters(process.observations()), &kept = process.hyperparameters();
  EXPECT_EQ(again.log_length, kept.log_length);
  EXPECT_EQ(again.log_signal, kept.log_signal);
  EXPECT_EQ(again.log_noise, kept.log_noise);
}

}  // namespace
}  // namespace regolab::surrogate
