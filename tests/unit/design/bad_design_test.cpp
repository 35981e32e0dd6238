// Every way a design can be wrong, and the message its author reads.
#include <gtest/gtest.h>

#include "scheduler/design/design_file.h"
#include "support/diagnostics.h"

namespace regolab {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using testing_support::at;
using testing_support::replaced;

const std::string kGood = R"(name: study
profile: quick
seeds: 1
particles: 100
array: L9
factors:
  theta_F: {unit: degree, levels: [5, 20, 40]}
  N_E: [2, 4, 6]
  L_S: [1 cm, 1.5 cm, 2 cm]
fixed:
  K_N: 5e4 N/m
  eta_N: 0.5 N s/m
  K_T: 5e4 N/m
  eta_T: 0.5 N s/m
  rotation: xz
tests: [settle, repose]
)";

Read<Design> read(const std::string& text, const std::map<std::string, std::string>& attachments = {}) {
  return read_design({text, "design.yaml", attachments}, {});
}

TEST(BadDesign, TheGoodOneIsGood) { EXPECT_TRUE(read(kGood).ok()); }

struct BadDesign {
  const char* name;
  const char* from;
  const char* to;
  int line, column;
  const char* text;
};

void PrintTo(const BadDesign& bad, std::ostream* out) { *out << bad.name; }

class BadDesigns : public ::testing::TestWithParam<BadDesign> {};

TEST_P(BadDesigns, AreToldWhereAndWhy) {
  const BadDesign& bad = GetParam();
  const std::string text = replaced(kGood, bad.from, bad.to);
  ASSERT_NE(text, kGood);
  const Read<Design> design = read(text);
  EXPECT_FALSE(design.value);
  EXPECT_THAT(design.diagnostics, ElementsAre(at(bad.line, bad.column, bad.text)));
}

INSTANTIATE_TEST_SUITE_P(
    Design, BadDesigns,
    ::testing::Values(
        BadDesign{"UnknownKey", "tests:", "test:", 16, 1,
                  "unknown key 'test' (nothing would read it) did you mean 'tests'?"},
        BadDesign{"UnknownFactor", "  N_E: [", "  rotaton: [none, x, z]\n  N_E: [", 8, 3,
                  "unknown factor 'rotaton' (no parameter has that name) did you mean 'rotation'?"},
        BadDesign{"DuplicateFactor", "  N_E: [2, 4, 6]", "  N_E: [2, 4, 6]\n  N_E: [2, 4]", 9, 3,
                  "duplicate key 'N_E' (already given in line 8)"},
        BadDesign{"MissingFactor", "  K_T: 5e4 N/m\n", "", 6, 1,
                  "missing factor 'K_T' (every microscopic parameter is a factor or fixed) add it to `factors`, or `K_T: "
                  "7.5e4 N/m` to `fixed`"},
        BadDesign{"FactorAndFixed", "rotation: xz", "rotation: xz\n  N_E: 6", 16, 8,
                  "fixed.N_E is also a factor (a parameter either varies or does not)"},
        BadDesign{"FactorAndParticles", "  N_E: [2, 4, 6]", "  N_E: [2, 4, 6]\n  particles: [50, 100, 200]", 6, 1,
                  "factors.particles is also set outside `factors`"},
        BadDesign{"WrongUnit", "[1 cm, 1.5 cm, 2 cm]", "[1 cm, 1.5 cm, 2 kPa]", 9, 23,
                  "factors.L_S: 2 kPa is a stress, expected m (largest particle diameter)"},
        BadDesign{"WrongUnitForAll", "unit: degree", "unit: cm", 7, 19,
                  "factors.theta_F.unit: 1 cm is a length, expected rad (particle friction angle)"},
        BadDesign{"UnitForNames", "N_E: [2, 4, 6]", "N_E: {unit: cm, levels: [2, 4, 6]}", 8, 15,
                  "elements per particle has no unit (its levels are names)"},
        BadDesign{"MissingUnit", "[1 cm, 1.5 cm, 2 cm]", "[1, 1.5 cm, 2 cm]", 9, 9, "factors.L_S: 1 has no unit"},
        BadDesign{"NegativeSize", "[1 cm,", "[-1 cm,", 9, 9, "factors.L_S: -1 cm (must be between 0.001 and 100 cm)"},
        BadDesign{"NotANumber", "[1 cm,", "[NaN cm,", 9, 9, "NaN cm is not a finite number"},
        BadDesign{"OneLevel", "[2, 4, 6]", "[2]", 8, 8,
                  "factors.N_E needs 2 to 64 levels (it is varied) list them, e.g. [a, b], or move it to `fixed`"},
        BadDesign{"ScalarFactor", "[2, 4, 6]", "6", 8, 8, "factors.N_E needs 2 to 64 levels"},
        BadDesign{"RepeatedLevel", "[1 cm, 1.5 cm", "[1 cm, 10 mm", 9, 15, "factors.L_S: level 10 mm stands twice"},
        BadDesign{"FourthLevel", "[2, 4, 6]", "[2, 4, 6, mixture]", 5, 8, "the factors do not fit L9 (3^4)"},
        BadDesign{"UnknownArray", "array: L9", "array: L10", 5, 8, "array: unknown array 'L10' (built in: L4 (2^3)"},
        BadDesign{"TooSmallArray", "array: L9", "array: L8", 5, 8,
                  "do not fit L8 (2^7) or (4^1 2^4) (3^3 is needed) use L9 (3^4); levels given: theta_F 3, N_E 3, L_S 3"},
        BadDesign{"ArrayAsList", "array: L9", "array: [L9]", 5, 8, "array is a list (must be a name or a map)"},
        BadDesign{"ArraySaysNothing", "array: L9", "array: {}", 5, 8, "array says nothing"},
        BadDesign{"NoSuchTable", "array: L9", "array: {table: points.csv}", 5, 16,
                  "array.table: 'points.csv' did not come with the design"},
        BadDesign{"ABillionParticles", "particles: 100", "particles: 1000000000", 4, 12, "(must be between 10 and 20000)"},
        BadDesign{"NoSeeds", "seeds: 1", "seeds: 0", 3, 8, "seeds: 0 (must be a whole number from 1 to 1000)"},
        BadDesign{"OwnSeedsWithoutAStart", "seeds: 1", "seeds: {each: 2}", 3, 8, "missing key 'seeds.first'"},
        BadDesign{"RepeatedSeed", "seeds: 1", "seeds: [3, 3]", 3, 12, "seeds: 3 stands twice"},
        BadDesign{"LongName", "name: study", "name: [a]", 1, 7, "name (must be text"},
        BadDesign{"BoxTooSmallForOnePoint", "particles: 100", "box: {length: 5 cm, width: 3.5 cm}", 4, 1,
                  "point 3: box 5 cm x 3.5 cm (each side must hold two of the largest particles, here 4 cm)"},
        BadDesign{"Truncated", "tests: [settle, repose]", "tests: [settle, re", 17, 1, "not valid YAML"},
        BadDesign{"Binary", "name: study", "name: st\x02udy", 1, 9, "not a text file (byte 0x02"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(BadDesign, RowsAreCheckedValueByValue) {
  const std::string rows = "array:\n  name: L9\n  rows:\n    - [5, 2, 1 cm]\n    - [5, 4]\n    - [7, 2, 1 cm]\n";
  EXPECT_THAT(read(replaced(kGood, "array: L9\n", rows)).diagnostics,
              ElementsAre(at(9, 7, "array.rows, row 2 (must list 3 values, one per factor)"),
                          at(10, 8, "row 3, theta_F: 7 is no level of it")));
  EXPECT_THAT(
      read(replaced(kGood, "array: L9\n", "array:\n  name: L8\n  rows: [[5, 2, 1 cm], [20, 4, 2 cm]]\n")).diagnostics,
      ElementsAre(at(6, 9, "array.name: 'L8' (the rows given are 2) write L2")));
  EXPECT_THAT(read(replaced(kGood, "array: L9\n", "array:\n  rows: [[5, 2, 1 cm], [5, 2, 10 mm]]\n")).diagnostics,
              ElementsAre(at(5, 1, "points 1 and 2 are the same (equal points give one run, which would count twice)")));
}

TEST(BadDesign, TableProblemsCarryTheTablesName) {
  const std::string text = replaced(kGood, "array: L9", "array: {table: t.csv}");
  const Read<Design> design = read(text, {{"t.csv", "theta_F_deg,N_E,L_S_cm\n5,2,1\n20,5,1\n"}});
  ASSERT_THAT(design.diagnostics, SizeIs(1));
  EXPECT_EQ(to_text(design.diagnostics[0]).substr(0, 10), "t.csv:3:4:");
}

TEST(BadDesign, AFailedTableDoesNotAccuseTheDesign) {
  const std::string text = "array: {table: t.csv}\nfixed: {K_N: 5e4 N/m}\n";
  EXPECT_THAT(read(text, {{"t.csv", "nonsense\n1\n2\n"}}).diagnostics, ElementsAre(at(1, 1, "unknown column 'nonsense'")));
}

TEST(BadDesign, AllErrorsComeAtOnce) {
  std::string text = replaced(kGood, "profile: quick", "profile: quik");
  text = replaced(text, "[1 cm,", "[-1 cm,");
  text = replaced(text, "  eta_T: 0.5 N s/m\n", "  eta_T: 0.5 Pa\n");
  text = replaced(text, "tests:", "test:");
  EXPECT_THAT(read(text).diagnostics,
              ElementsAre(at(2, 10, "quik"), at(9, 9, "-1 cm"), at(14, 10, "0.5 Pa is a stress"), at(16, 1, "'test'")));
}

TEST(BadDesign, NothingVaries) {
  EXPECT_THAT(read("fixed: {theta_F: 20 deg, K_N: 1e5 N/m, eta_N: 0.25 N s/m, K_T: 7.5e4 N/m, eta_T: 1 N s/m, L_S: 1 cm, "
                   "N_E: 6, rotation: none}\n")
                  .diagnostics,
              ElementsAre(at(1, 1, "no factors (a design varies something)")));
  EXPECT_THAT(read("name: x\n").diagnostics, SizeIs(8));
}

TEST(BadDesign, TooManyStages) {
  const std::string text = replaced(kGood, "seeds: 1", "seeds: 1000");
  const std::string full = replaced(replaced(replaced(text, "array: L9", "array: full"), "  rotation: xz\n", ""),
                                    "factors:\n", "factors:\n  rotation: [x, z]\n");
  EXPECT_THAT(read(full).diagnostics, ElementsAre(at(0, 0, "the study has 162000 stages (at most 100000)")));
}

}  // namespace
}  // namespace regolab
