#include "scheduler/gap/reach.h"

#include <gmock/gmock.h>

#include "scheduler/gap/observation_file.h"
#include "unit/gap/made_up_world.h"

namespace regolab::gap {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ObservationSet read(const std::string& material, const std::string& observables) {
  auto out = read_observations("f.yaml", "format: observations/1\ncase: c\nmaterial: {" + material + "}\nobservables:\n" + observables);
  for (const Diagnostic& d : out.diagnostics) ADD_FAILURE() << to_text(d);
  return out.value.value_or(ObservationSet{});
}

const std::string kDensity = "- {id: bulk_density, value: 1.6, unit: g/cm3, standard_error: 0.01}\n";
const std::string kAt50 = "- {id: sigma1_at_sigma3_50kPa, value: 150, unit: kPa, standard_error: 5}\n";

TEST(Reach, AMaterialOfTheBankIsWithin) {
  const Reach reach = reach_of(strength_emulator(), read("theta_F_deg: 30", kDensity));
  EXPECT_THAT(reach.refused, IsEmpty());
  EXPECT_THAT(reach.left_out, IsEmpty());
}

TEST(Reach, AMaterialOutsideTheBankIsRefusedWithWhatTheBankHas) {
  const ObservationSet set = read("theta_F_deg: 80", kDensity);
  const Reach reach = reach_of(strength_emulator(), set);
  ASSERT_THAT(reach.refused, ElementsAre(AllOf(Field(&OutOfReach::key, "theta_F"), Field(&OutOfReach::text, AllOf(HasSubstr("80 deg"), HasSubstr("leave it out"))))));
  EXPECT_EQ(set.places.at("theta_F"), (Place{3, 25}));
}

TEST(Reach, AValueWithinItsErrorOfTheBankIsTaken) {
  EXPECT_THAT(reach_of(strength_emulator(), read("theta_F_deg: 59, theta_F_deg_standard_error: 3", kDensity)).refused, IsEmpty());
  EXPECT_THAT(reach_of(strength_emulator(), read("theta_F_deg: 80, theta_F_deg_standard_error: 3", kDensity)).refused, testing::SizeIs(1));
}

TEST(Reach, AStressThatTheBankLacksIsLeftOutWithTheCommandThatRunsIt) {
  const Reach reach = reach_of(strength_emulator(), read("", kDensity + kAt50));
  EXPECT_THAT(reach.refused, IsEmpty());
  EXPECT_THAT(reach.left_out, ElementsAre(AllOf(Field(&Unused::id, "stress at 50 kPa"),
                                                Field(&Unused::why, AllOf(HasSubstr("the bank has 1.25, 10 kPa"), HasSubstr("--sigma3 '1.25 10 50' -o bank.csv"), HasSubstr("min on 2 cores"))))));
}

TEST(Reach, ASetOfWhichNothingIsLeftIsRefusedAtItsPlace) {
  const ObservationSet set = read("", kAt50);
  const Reach reach = reach_of(strength_emulator(), set);
  ASSERT_THAT(reach.refused, ElementsAre(Field(&OutOfReach::text, AllOf(HasSubstr("nothing to compare"), HasSubstr("--sigma3")))));
  EXPECT_EQ(set.places.at(reach.refused[0].key).line, 5);
}

}  // namespace
}  // namespace regolab::gap
