#include "input/unit_convert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace regolab {
namespace {

using ::testing::HasSubstr;

struct Conversion {
  double value;
  const char* unit;
  const char* si;
  double expected;
};

TEST(UnitConvert, ReadsTheUnitsPeopleWrite) {
  constexpr double kPi = std::numbers::pi;
  const Conversion cases[] = {
      {0.25, "N.s/m", "N s/m", 0.25},
      {0.25, "N s/m", "N s/m", 0.25},
      {0.25, "Ns/m", "N s/m", 0.25},
      {0.25, "N*s/m", "N s/m", 0.25},
      {0.25, "kg/s", "N s/m", 0.25},
      {90, "degree", "rad", kPi / 2},
      {90, "deg", "rad", kPi / 2},
      {90, "degrees", "rad", kPi / 2},
      {90, "\xC2\xB0", "rad", kPi / 2},
      {1, "rad", "rad", 1},
      {1.25, "kPa", "Pa", 1250},
      {1, "cm", "m", 0.01},
      {5, "mm", "m", 0.005},
      {2.93, "g/cm3", "kg/m3", 2930},
      {2930, "kg m-3", "kg/m3", 2930},
      {163, "cm/s2", "m/s2", 1.63},
      {7.5, "kN/m", "N/m", 7500},
      {20, "%", "1", 0.2},
      {3, "1", "1", 3},
      {1, "MPa", "Pa", 1e6},
  };
  for (const Conversion& c : cases) {
    const auto converted = convert_to_si(c.value, c.unit, c.unit, c.si, "quantity");
    ASSERT_TRUE(converted.ok()) << c.unit << ": " << converted.error().text;
    EXPECT_NEAR(*converted, c.expected, 1e-12 * c.expected) << c.unit;
  }
}

std::string refusal(const char* written, double value, const char* unit, const char* si, const char* what) {
  const auto converted = convert_to_si(value, written, unit, si, what);
  return converted.ok() ? "accepted" : converted.error().text;
}

TEST(UnitConvert, NamesTheWrongDimension) {
  EXPECT_EQ(refusal("5e4 N", 5e4, "N", "N/m", "stiffness"), "5e4 N is a force, expected N/m (stiffness)");
  EXPECT_EQ(refusal("2 s", 2, "s", "Pa", "stress"), "2 s is a time, expected Pa (stress)");
  EXPECT_EQ(refusal("3 furlong^4", 3, "furlong^4", "m", "length"),
            "3 furlong^4 is another kind of quantity, expected m (length)");
}

TEST(UnitConvert, DoesNotInvertUnits) {  // the library alone would turn seconds into hertz
  EXPECT_THAT(refusal("2 m/N", 2, "m/N", "N/m", "stiffness"), HasSubstr("expected N/m"));
  EXPECT_THAT(refusal("2 s", 2, "s", "1/s", "rate"), HasSubstr("is a time"));
}

TEST(UnitConvert, KeepsAnglesAndNumbersApart) {
  EXPECT_THAT(refusal("20 degree", 20, "degree", "1", "inertial number"), HasSubstr("is an angle, expected a pure number"));
  EXPECT_THAT(refusal("0.3 1", 0.3, "1", "rad", "particle friction angle"), HasSubstr("is a pure number, expected rad"));
}

TEST(UnitConvert, CaseCountsAndIsSaid) {
  EXPECT_EQ(refusal("5 KPA", 5, "KPA", "Pa", "stress"), "unknown unit 'KPA', expected Pa (stress) (case counts) write kPa");
  EXPECT_EQ(*convert_to_si(5, "5 kPa ", " kPa ", "Pa", "stress"), 5000);
}

TEST(UnitConvert, RefusesWhatIsNoUnit) {
  for (const char* unit :
       {"Newton meters per", "m)(", "5 m", "", "seconds since 2000", "m^999999999", "lg(re 1 mW)", "xyzzy"}) {
    EXPECT_NE(refusal(unit, 1, unit, "m", "length"), "accepted") << unit;
  }
  EXPECT_NE(refusal("long", 1, std::string(5000, 'm').c_str(), "m", "length"), "accepted");
}

}  // namespace
}  // namespace regolab
