/// Designs that are wrong, through the real programs: `file:line:column: problem (why) remedy`, exit code 3, nothing made.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/client/programs.h"

namespace regolab {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class BadDesign : public Programs {
 protected:
  /// What `regolab run` says about the text; checks what every refusal has in common.
  std::string refusal(const std::string& text) {
    write("a.yaml", text);
    const Ran ran = regolab("run a.yaml");
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_THAT(ran.err, HasSubstr("a.yaml:"));
    EXPECT_THAT(listing(), ElementsAre("a.yaml")) << "a refused design leaves files behind";
    return ran.err;
  }
};

TEST_F(BadDesign, UnknownKeyGetsASuggestion) {
  const std::string said = refusal(spoiled(good_design(), "  K_N: 5e4", "  K_M: 5e4"));
  EXPECT_THAT(said, HasSubstr("a.yaml:10:3: unknown key 'fixed.K_M'"));
  EXPECT_THAT(said, HasSubstr("did you mean 'K_N'?"));
  EXPECT_THAT(said, HasSubstr("  K_M: 5e4 N/m\n    ^"));
}

TEST_F(BadDesign, DuplicateKey) {
  EXPECT_THAT(refusal(spoiled(good_design(), "seeds: 1\n", "seeds: 1\nseeds: 2\n")),
              HasSubstr("a.yaml:5:1: duplicate key 'seeds'"));
}

TEST_F(BadDesign, WrongUnit) {
  const std::string said = refusal(spoiled(good_design(), "K_N: 5e4 N/m", "K_N: 5e4 N"));
  EXPECT_THAT(said, HasSubstr("a.yaml:10:8: "));
  EXPECT_THAT(said, HasSubstr("5e4 N is a force"));
  EXPECT_THAT(said, HasSubstr("N/m"));
}

TEST_F(BadDesign, MissingUnit) {
  EXPECT_THAT(refusal(spoiled(good_design(), "K_N: 5e4 N/m", "K_N: 5e4")), HasSubstr("a.yaml:10:8: "));
}

TEST_F(BadDesign, MissingFactor) {
  const std::string said = refusal(spoiled(good_design(), "  K_T: 5e4 N/m\n", ""));
  EXPECT_THAT(said, HasSubstr("K_T"));
}

TEST_F(BadDesign, LevelCountThatFitsNoArray) {
  const std::string said = refusal(spoiled(good_design(), "[5 degree, 40 degree]", "[5 degree, 10 degree, 40 degree]"));
  EXPECT_THAT(said, HasSubstr("L4"));
  EXPECT_THAT(said, HasSubstr("3 levels"));
}

TEST_F(BadDesign, NegativeSize) {
  EXPECT_THAT(refusal(spoiled(good_design(), "L_S: [1 cm", "L_S: [-1 cm")), HasSubstr("a.yaml:8:9: "));
}

TEST_F(BadDesign, NotANumber) {
  EXPECT_THAT(refusal(spoiled(good_design(), "K_N: 5e4 N/m", "K_N: .nan N/m")), HasSubstr("a.yaml:10:8: "));
  EXPECT_THAT(refusal(spoiled(good_design(), "K_N: 5e4 N/m", "K_N: inf N/m")), HasSubstr("a.yaml:10:8: "));
}

TEST_F(BadDesign, ABillionParticles) {
  const std::string said = refusal(spoiled(good_design(), "particles: 120", "particles: 1000000000"));
  EXPECT_THAT(said, HasSubstr("a.yaml:3:12: "));
  EXPECT_THAT(said, HasSubstr("20000"));
}

TEST_F(BadDesign, TruncatedFile) {
  const std::string whole = good_design();
  EXPECT_THAT(refusal(whole.substr(0, whole.find("40 degree"))), HasSubstr("a.yaml:"));
  EXPECT_THAT(refusal(whole.substr(0, whole.find("N_E"))), HasSubstr("N_E"));
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
}

TEST_F(BadDesign, BinaryFile) {
  const std::string said = refusal(std::string("\x7f\x45LF\x02\x01\x00\xff\xfe\x80", 10));
  EXPECT_THAT(said, HasSubstr("not a text file"));
}

TEST_F(BadDesign, AllProblemsAreToldAtOnce) {
  std::string text = spoiled(good_design(), "K_N: 5e4 N/m", "K_N: 5e4 N");
  text = spoiled(text, "seeds: 1", "seeds: 1\nseads: 2");
  text = spoiled(text, "particles: 120", "particles: 1000000000");
  const std::string said = refusal(text);
  EXPECT_THAT(said, HasSubstr("a.yaml:3:12: "));
  EXPECT_THAT(said, HasSubstr("a.yaml:5:1: unknown key 'seads'"));
  EXPECT_THAT(said, HasSubstr("a.yaml:11:8: "));
  EXPECT_THAT(said, HasSubstr("3 problems; nothing was changed"));
}

TEST_F(BadDesign, AMissingTableAndABadLineInATable) {
  const std::string with_table = spoiled(good_design(), "array: L4", "array: {table: points.csv}");
  EXPECT_THAT(refusal(with_table), HasSubstr("cannot read the table points.csv (No such file or directory)"));
}

TEST_F(BadDesign, UnknownProfileOnTheCommandLine) {
  write("a.yaml", good_design());
  const Ran ran = regolab("run a.yaml --profile fast");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("fast"));
  EXPECT_THAT(ran.err, HasSubstr("quick"));
}

TEST_F(BadDesign, JsonListsTheProblems) {
  write("a.yaml", spoiled(good_design(), "K_N: 5e4 N/m", "K_N: 5e4 N"));
  const Ran ran = regolab("design show a.yaml --json");
  EXPECT_EQ(ran.code, 3);
  const auto document = nlohmann::json::parse(ran.out);
  EXPECT_EQ(document["format"], "regolab.diagnostics/1");
  EXPECT_EQ(document["diagnostics"][0]["line"], 10);
}

}  // namespace
}  // namespace regolab
