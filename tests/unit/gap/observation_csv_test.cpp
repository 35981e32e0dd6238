#include "scheduler/gap/observation_csv.h"

#include <gmock/gmock.h>

#include "unit/gap/dev_files.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using testing_support::at;
using testing_support::replaced;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

std::string example(const char* name) { return testing_support::read_file(std::string(REGOLAB_SOURCE "/client/examples/") + name); }
CsvSource source() { return {"map.yaml", example("measurements-map.yaml"), "m.csv", example("measurements.csv")}; }

const Scalar& scalar(const ObservationSet& set, const std::string& id) {
  static const Scalar none;
  for (const Scalar& s : set.scalars) {
    if (s.id == id) return s;
  }
  ADD_FAILURE() << "no " << id;
  return none;
}

TEST(Measurements, RowsAreRepeatsAndStressesMakeIds) {
  const auto read = read_measurements(source());
  for (const Diagnostic& d : read.diagnostics) ADD_FAILURE() << to_text(d);
  ASSERT_TRUE(read.ok());
  const Scalar& density = scalar(*read.value, "bulk_density");
  EXPECT_NEAR(density.value, 1634, 1e-9);
  EXPECT_NEAR(density.standard_error, 8.8882 / std::sqrt(3.0), 1e-3);  // s of 1631, 1644, 1627
  EXPECT_EQ(density.seeds, 3);
  const Scalar& strength = scalar(*read.value, "sigma1_at_sigma3_1.25kPa");
  EXPECT_NEAR(strength.value, 5900, 1e-9);
  EXPECT_NEAR(strength.standard_error, 300, 1e-9);
  EXPECT_EQ(read.value->scalars.size(), 5U);
}

TEST(Measurements, ARowAloneNeedsItsError) {
  CsvSource s = source();
  s.csv_text = replaced(s.csv_text, "slope,angle,,39.0,\nslope,angle,,36.4,\n", "");
  EXPECT_THAT(read_measurements(s).diagnostics, ElementsAre(AllOf(at(5, 14, "no standard error"), Field(&Diagnostic::file, "m.csv"))));
  EXPECT_TRUE(read_measurements(s, MissingErrors::kAssume).ok());
}

TEST(Measurements, BadCellsAndColumnsAreToldWhereTheyStand) {
  CsvSource s = source();
  s.csv_text = replaced(source().csv_text, "1.644", "wet");
  EXPECT_THAT(read_measurements(s).diagnostics, ElementsAre(AllOf(at(3, 15, "'wet'"), Field(&Diagnostic::file, "m.csv"))));
  s = source();
  s.map_text = replaced(s.map_text, "column: value", "column: valeu");
  EXPECT_THAT(read_measurements(s).diagnostics, ElementsAre(AllOf(at(8, 30, "did you mean 'value'?"), Field(&Diagnostic::file, "map.yaml"))));
  s.map_text = replaced(source().map_text, "unit: deg", "unit: kg");
  EXPECT_THAT(read_measurements(s).diagnostics, ElementsAre(Field(&Diagnostic::text, HasSubstr("is a mass"))));
}

TEST(Measurements, CurvesComeFromTwoColumns) {
  const CsvSource s{"map.yaml",
                    "format: observation-map/1\ncase: c\ncurves:\n- {id: sigma1, sigma3: 5 kPa, x_column: strain, x_unit: '%', y_column: 2, y_unit: kPa, y_standard_error_column: e}\n", "m.csv",
                    "strain,s1,e\n0,5,0.1\n5,15,0.5\n10,16,0.5\n15,16,0.6\n17,15.5,0.6\n20,15.8,0.6\n"};
  const auto read = read_measurements(s);
  for (const Diagnostic& d : read.diagnostics) ADD_FAILURE() << to_text(d);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read.value->curves.at(0).id, "sigma1_at_sigma3_5kPa");
  EXPECT_DOUBLE_EQ(read.value->curves[0].x.at(1), 0.05);
  EXPECT_DOUBLE_EQ(read.value->curves[0].y.at(1), 15000);
}

}  // namespace
}  // namespace regolab::gap
