#include "scheduler/gap/bank.h"

#include <gmock/gmock.h>

#include <cmath>

#include "unit/gap/dev_files.h"

namespace regolab::gap {
namespace {

using testing_support::at;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

BankSource source(int point, double density, double cohesion) {
  BankSource s{.experiment = "e", .point = point, .seed = 7, .profile = "quick", .inputs = {{{"theta_F", "rad"}, 0.1 * point}, {{"K_N", "N/m"}, 5e4}}, .readings = {}};
  if (density > 0) s.readings.scalars["bulk_density"] = {.value = density};
  if (cohesion > 0) s.inputs.push_back({{"cohesion", "Pa"}, cohesion});
  return s;
}

TEST(Bank, AnEffectThatASourceDoesNotNameIsOffThere) {
  const Bank bank = bank_of({source(1, 1500, 0), source(2, 1600, 300), source(3, 0, 0)});
  ASSERT_EQ(bank.rows.size(), 2U) << "a run without numbers is no row";
  ASSERT_TRUE(bank.input("cohesion"));
  EXPECT_EQ(bank.rows[0].inputs[*bank.input("cohesion")], 0);
  EXPECT_EQ(bank.rows[1].inputs[*bank.input("cohesion")], 300);
  EXPECT_THAT(bank.features, ElementsAre("bulk_density"));
}

TEST(Bank, IsReadBackAsItWasWritten) {
  auto second = source(2, 1600, 300);
  second.readings.scalars["sigma1_peak_at_sigma3_2.5kPa"] = {.value = 8123.456};
  second.readings.scalars["sigma3_measured_at_sigma3_2.5kPa"] = {.value = 2510};
  second.readings.scalars["repose_angle"] = {.value = 0.7};
  const Bank bank = bank_of({source(1, 1500, 0), second});
  const auto read = read_bank("bank.csv", bank_csv(bank));
  for (const Diagnostic& d : read.diagnostics) ADD_FAILURE() << to_text(d);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value->inputs, bank.inputs);
  EXPECT_EQ(read.value->features, bank.features);
  EXPECT_THAT(bank.features, ElementsAre("bulk_density", "repose_angle", "sigma1_peak_ratio_2.5", "sigma3_measured_ratio_2.5"));
  ASSERT_EQ(read.value->rows.size(), 2U);
  EXPECT_TRUE(std::isnan(read.value->rows[0].features[*bank.feature("repose_angle")]));
  for (std::size_t k = 0; k < bank.features.size(); ++k) EXPECT_NEAR(read.value->rows[1].features[k], bank.rows[1].features[k], 1e-6 * std::abs(bank.rows[1].features[k]));
  EXPECT_EQ(read.value->rows[1].seed, 7U);
  EXPECT_EQ(read.value->rows[1].profile, "quick");
}

TEST(Bank, DamageIsToldAtItsPlace) {
  const std::string head = "experiment,point,seed,profile,theta_F_rad,bulk_density_kg_per_m3\n";
  const auto problems = [&](const std::string& rest) { return read_bank("b", head + rest).diagnostics; };
  EXPECT_THAT(problems("e,1,1,quick,0.1,heavy\n"), ElementsAre(at(2, 17, "'heavy'")));
  EXPECT_THAT(problems("e,1,1,quick,,1500\n"), ElementsAre(at(2, 13, "finite number")));
  EXPECT_THAT(problems("e,1,1,quick,0.1\n"), ElementsAre(at(2, 1, "5 cells (the header has 6)")));
  EXPECT_THAT(problems("e,1,1,quick,0.1,1500\ne,1,1,quick,0.1,1501\n"), ElementsAre(at(3, 1, "line 2 already")));
  EXPECT_THAT(problems(""), ElementsAre(Field(&Diagnostic::text, HasSubstr("no rows"))));
  EXPECT_THAT(read_bank("b", "").diagnostics, ElementsAre(Field(&Diagnostic::text, HasSubstr("empty file"))));
  EXPECT_THAT(read_bank("b", "a,b\n1,2\n").diagnostics, ElementsAre(at(1, 1, "must be `experiment`")));
}

}  // namespace
}  // namespace regolab::gap
