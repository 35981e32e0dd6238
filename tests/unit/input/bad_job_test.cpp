// Every way a job file can be wrong, and the message its author reads.
#include <gtest/gtest.h>

#include "input/job_file.h"
#include "support/diagnostics.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing_support::at;
using testing_support::replaced;

const std::string kGood = R"(profile: quick
seed: 1
particles: 300
box: {length: 3.63 cm, width: 2.18 cm}
micro:
  theta_F: 20 degree
  K_N: 1e5 N/m
  eta_N: 0.25 N.s/m
  K_T: 7.5e4 N/m
  eta_T: 1 N.s/m
  L_S: 1 cm
  N_E: 6
  rotation: none
tests: [settle, repose, stress]
stress: {sigma3: [1.25 kPa, 10 kPa]}
)";

struct BadJob {
  const char* name;
  const char* from;
  const char* to;
  int line, column;
  const char* text;  ///< part of the message
};

void PrintTo(const BadJob& bad, std::ostream* out) { *out << bad.name; }

class BadJobs : public ::testing::TestWithParam<BadJob> {};

TEST_P(BadJobs, AreToldWhereAndWhy) {
  const BadJob& bad = GetParam();
  const std::string text = replaced(kGood, bad.from, bad.to);
  ASSERT_NE(text, kGood);
  const Read<Job> read = read_job(text, "job.yaml");
  EXPECT_FALSE(read.ok());
  EXPECT_FALSE(read.value);
  EXPECT_THAT(read.diagnostics, ElementsAre(at(bad.line, bad.column, bad.text)));
}

INSTANTIATE_TEST_SUITE_P(
    Job, BadJobs,
    ::testing::Values(
        BadJob{"UnknownKey", "seed:", "seeed:", 2, 1, "unknown key 'seeed' (nothing would read it) did you mean 'seed'?"},
        BadJob{"UnknownMicroKey", "  L_S:", "  gravty: 1.6 m/s2\n  L_S:", 11, 3, "did you mean 'gravity'?"},
        BadJob{"UnknownKeyFarFromAll", "seed: 1", "seed: 1\ncolour: red", 3, 1,
               "unknown key 'colour' (nothing would read it) known: profile, seed"},
        BadJob{"DuplicateKey", "  L_S: 1 cm", "  L_S: 1 cm\n  K_N: 2e5 N/m", 12, 3,
               "duplicate key 'K_N' (already given in line 7)"},
        BadJob{"WrongUnit", "1e5 N/m", "5e4 N", 7, 8, "micro.K_N: 5e4 N is a force, expected N/m (stiffness)"},
        BadJob{"UnknownUnit", "1 cm", "1 centimetter", 11, 8,
               "unknown unit 'centimetter', expected m (largest particle diameter)"},
        BadJob{"MissingUnit", "20 degree", "20", 6, 12,
               "micro.theta_F: 20 has no unit (a particle friction angle needs one) write e.g. `20 deg`"},
        BadJob{"MissingUnitOfPressure", "10 kPa", "10", 15, 29, "stress.sigma3: 10 has no unit (a stress needs one)"},
        BadJob{"MissingKey", "  eta_T: 1 N.s/m\n", "", 6, 3,
               "missing key 'micro.eta_T' (nothing stands in for it) add e.g. `eta_T: 1 N s/m`"},
        BadJob{"NegativeSize", "L_S: 1 cm", "L_S: -1 cm", 11, 8,
               "micro.L_S: -1 cm (must be between 0.001 and 100 cm) the article uses 0.5 to 2 cm"},
        BadJob{"NotANumberValue", "eta_N: 0.25 N.s/m", "eta_N: .nan N.s/m", 8, 10,
               "micro.eta_N: .nan N.s/m is not a finite number"},
        BadJob{"Infinity", "1e5 N/m", ".inf N/m", 7, 8, "is not a finite number"},
        BadJob{"Overflow", "1e5 N/m", "1e999 N/m", 7, 8, "is not a finite number"},
        BadJob{"WordForNumber", "1e5 N/m", "stiff", 7, 8, "micro.K_N: 'stiff' is not a number (a stiffness is needed)"},
        BadJob{"DecimalComma", "L_S: 1 cm", "L_S: 1,5 cm", 11, 8, "has a comma (decimals take a point here)"},
        BadJob{"ListForNumber", "L_S: 1 cm", "L_S: [1 cm]", 11, 8, "micro.L_S is a list (must be one value) write `1 cm`"},
        BadJob{"EmptyValue", "L_S: 1 cm", "L_S:", 11, 3, "micro.L_S has no value (the key stands alone)"},
        BadJob{"ABillionParticles", "particles: 300", "particles: 1000000000", 3, 12,
               "particles: 1000000000 (must be between 10 and 20000)"},
        BadJob{"HalfAParticle", "particles: 300", "particles: 300.5", 3, 12,
               "300.5 (must be a whole number) write one between 10 and 20000"},
        BadJob{"TooFewParticles", "particles: 300", "particles: 9", 3, 12, "(must be between 10 and 20000)"},
        BadJob{"NegativeSeed", "seed: 1", "seed: -1", 2, 7, "seed: -1 (must be a whole number from 0 to 9007199254740991)"},
        BadJob{"FrictionOf90", "20 degree", "90 degree", 6, 12, "(must be between 0 and 89 deg)"},
        BadJob{"AngleAsNumber", "20 degree", "0.3 1", 6, 12, "0.3 1 is a pure number, expected rad"},
        BadJob{"UnknownKind", "N_E: 6", "N_E: 5", 12, 8,
               "'5' is no elements per particle (12 is the mixture of 2, 4 and 6) choose one of 2, 4, 6, mixture"},
        BadJob{"UnknownRotation", "rotation: none", "rotation: y", 13, 13, "choose one of none, x, z, xz"},
        BadJob{"UnknownProfile", "profile: quick", "profile: quik", 1, 10,
               "unknown name 'quik' (it must be one of those known) did you mean 'quick'?"},
        BadJob{"UnknownTest", "repose,", "reposs,", 14, 17,
               "tests: unknown name 'reposs' (it must be one of those known) did you mean 'repose'?"},
        BadJob{"PlateTooWide", "tests: [settle, repose, stress]", "tests: [settle, penetration]", 14, 1,
               "plate 3 cm x 0.3 cm in a box 3.63 cm x 2.18 cm (at each side a particle of mean size, here 0.6 cm, needs room) widen the "
               "box, or take a smaller plate"},
        BadJob{"PlateTwice", "stress:", "penetration: {plates: [3 mm, 0.3 cm]}\nstress:", 15, 30,
               "penetration.plates: 0.3 cm stands twice (each plate is pushed in once) remove one"},
        BadJob{"PlateWithoutUnit", "stress:", "penetration: {plates: [3]}\nstress:", 15, 24, "penetration.plates"},
        BadJob{"PlatesAsOneLength", "stress:", "penetration: {plates: 3 mm}\nstress:", 15, 23,
               "penetration.plates (must be a list of 1 to 20 thicknesses) write e.g. [3 mm, 10 mm]"},
        BadJob{"PlateWidthAsStress", "stress:", "penetration: {width: 3 kPa}\nstress:", 15, 22, "3 kPa is a stress, expected m (length)"},
        BadJob{"TestsAsText", "[settle, repose, stress]", "all", 14, 8, "tests (must be a list)"},
        BadJob{"RepeatedPressure", "10 kPa]", "1250 Pa]", 15, 29, "stress.sigma3: 1250 Pa stands twice"},
        BadJob{"HugePressure", "10 kPa", "10 GPa", 15, 29, "(must be between 0.001 and 1000 kPa)"},
        BadJob{"NoPressure", "[1.25 kPa, 10 kPa]", "[]", 15, 18, "must be a list of 1 to 20 pressures"},
        BadJob{"SmallBox", "width: 2.18 cm", "width: 1.9 cm", 4, 1,
               "box 3.63 cm x 1.9 cm (each side must hold two of the largest particles, here 2 cm)"},
        BadJob{"HalfABox", ", width: 2.18 cm", "", 4, 6, "missing key 'box.width'"},
        BadJob{"BoxAsText", "{length: 3.63 cm, width: 2.18 cm}", "3 cm", 4, 6, "box is text (must be a map)"},
        BadJob{"UnknownNumerics", "seed: 1", "seed: 1\nnumerics: {axial_strian: 0.2}", 3, 12,
               "did you mean 'axial_strain'?"},
        BadJob{"NumericsOutOfRange", "seed: 1", "seed: 1\nnumerics: {step_fraction: 2}", 3, 27,
               "(must be between 0.005 and 0.4)"},
        BadJob{"NumericsWithUnit", "seed: 1", "seed: 1\nnumerics: {mass_floor: 2 kg}", 3, 24,
               "2 kg is a mass, expected a pure number"},
        BadJob{"RatioWithUnit", "  L_S:", "  damping_unit: absolut\n  L_S:", 11, 17, "did you mean 'absolute'?"},
        BadJob{"Truncated", "{sigma3: [1.25 kPa, 10 kPa]}", "{sigma3: [1.25 kPa, 1", 16, 1, "not valid YAML"},
        BadJob{"Binary", "seed: 1", "seed: \x01", 2, 7, "not a text file (byte 0x01"},
        BadJob{"Alias", "seed: 1", "seed: &s 1", 2, 7, "anchor or alias (they are not used here)"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(BadJob, AllErrorsComeAtOnceInOrder) {
  std::string text = replaced(kGood, "seed:", "sed:");
  text = replaced(text, "1e5 N/m", "5e4 N");
  text = replaced(text, "L_S: 1 cm", "L_S: -1 cm");
  text = replaced(text, "reposs", "x");
  EXPECT_THAT(read_job(text, "job.yaml").diagnostics,
              ElementsAre(at(2, 1, "unknown key 'sed'"), at(7, 8, "is a force"), at(11, 8, "must be between")));
}

TEST(BadJob, EveryMissingParameterIsNamed) {
  const Read<Job> read = read_job("micro: {theta_F: 20 deg}\n", "job.yaml");
  EXPECT_EQ(read.diagnostics.size(), 7u);
  EXPECT_THAT(read_job("seed: 1\n", "job.yaml").diagnostics, ElementsAre(at(1, 1, "missing key 'micro'")));
}

TEST(BadJob, WhatIsNoMapAtAll) {
  EXPECT_THAT(read_job("just words\n", "job.yaml").diagnostics, ElementsAre(at(1, 1, "the file is text (must be a map)")));
  EXPECT_THAT(read_job("- a\n- b\n", "job.yaml").diagnostics, ElementsAre(at(1, 1, "the file is a list (must be a map)")));
}

TEST(BadJob, TheWholeMessageReadsLikeACompilers) {
  const Read<Job> read = read_job(replaced(kGood, "1e5 N/m", "5e4 N"), "my/job.yaml");
  ASSERT_EQ(read.diagnostics.size(), 1u);
  EXPECT_EQ(to_text(read.diagnostics[0]),
            "my/job.yaml:7:8: micro.K_N: 5e4 N is a force, expected N/m (stiffness)\n    K_N: 5e4 N\n         ^");
}

}  // namespace
}  // namespace regolab
