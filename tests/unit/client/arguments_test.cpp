#include "client/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace regolab::client {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::vector<std::string>& words) {
  const Parsed parsed = parse(words);
  EXPECT_TRUE(parsed.leave);
  EXPECT_EQ(parsed.outcome.exit, Exit::kUsage);
  return parsed.outcome.text;
}

class ArgumentsTest : public ::testing::Test {
 protected:
  void SetUp() override { unsetenv("REGOLAB_SERVER"); }
  void TearDown() override { unsetenv("REGOLAB_SERVER"); }
};

TEST_F(ArgumentsTest, ReadsAVerbWithItsOptionsAndThoseOfEveryVerb) {
  const Parsed parsed =
      parse({"run", "study.yaml", "--profile", "quick", "--seeds", "2", "--workers=3", "--db", "x.db", "--json"});
  ASSERT_FALSE(parsed.leave) << parsed.outcome.text;
  EXPECT_EQ(parsed.arguments.verb, "run");
  EXPECT_EQ(parsed.arguments.design, "study.yaml");
  EXPECT_EQ(parsed.arguments.profile, "quick");
  EXPECT_EQ(parsed.arguments.seeds, 2U);
  EXPECT_EQ(parsed.arguments.workers, 3U);
  EXPECT_EQ(parsed.arguments.database, "x.db");
  EXPECT_TRUE(parsed.arguments.json);
}

TEST_F(ArgumentsTest, NestedVerbsHaveTwoWords) {
  EXPECT_EQ(parse({"article", "compare", "last"}).arguments.verb, "article compare");
  EXPECT_EQ(parse({"article", "functions", "--seed", "7"}).arguments.random_seed, 7U);
  EXPECT_EQ(parse({"design", "show", "a.yaml"}).arguments.verb, "design show");
}

TEST_F(ArgumentsTest, GapVerbsReadFilesAndExperiments) {
  const Parsed import = parse({"gap", "import", "m.csv", "--map", "map.yaml", "--assume-errors", "-o", "obs.yaml"});
  ASSERT_FALSE(import.leave) << import.outcome.text;
  EXPECT_EQ(import.arguments.verb, "gap import");
  EXPECT_EQ(import.arguments.observations, "m.csv");
  EXPECT_EQ(import.arguments.map, "map.yaml");
  EXPECT_TRUE(import.arguments.assume_errors);
  const Parsed bank = parse({"gap", "bank", "a", "b", "-o", "bank.csv"});
  EXPECT_EQ(bank.arguments.verb, "gap bank");
  EXPECT_EQ(bank.arguments.experiments, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(bank.arguments.output, "bank.csv");
}

TEST_F(ArgumentsTest, UnknownWordsGetTheNearestKnownOne) {
  EXPECT_THAT(refusal({"rnu", "x"}), HasSubstr("unknown verb `rnu`"));
  EXPECT_THAT(refusal({"statsu"}), HasSubstr("did you mean `status`?"));
  EXPECT_THAT(refusal({"--db", "run", "statsu"}), HasSubstr("did you mean `status`?"));
  EXPECT_THAT(refusal({"article", "chek"}), HasSubstr("did you mean `check`?"));
  EXPECT_THAT(refusal({"run", "a.yaml", "--profil", "quick"}), HasSubstr("did you mean `--profile`?"));
  EXPECT_THAT(refusal({"frobnicate"}), HasSubstr("see `regolab --help`"));
}

TEST_F(ArgumentsTest, BadValuesAreUsageErrors) {
  EXPECT_THAT(refusal({"run", "a.yaml", "--seeds", "0"}), HasSubstr("--seeds"));
  EXPECT_THAT(refusal({"run", "a.yaml", "--workers", "many"}), HasSubstr("--workers"));
  EXPECT_THAT(refusal({"run"}), HasSubstr("DESIGN is required"));
  EXPECT_THAT(refusal({"status", "a", "b"}), HasSubstr("b"));
  EXPECT_THAT(refusal({"results", "--csv", "--json"}), HasSubstr("--csv and --json together"));
  EXPECT_THAT(refusal({"article", "functions", "--seed", "-3"}), HasSubstr("--seed"));
  EXPECT_THAT(refusal({"article", "functions", "last", "--article"}), HasSubstr("--article with an experiment"));
}

TEST_F(ArgumentsTest, AWrongServerAddressIsToldBeforeAnythingIsDialled) {
  EXPECT_THAT(refusal({"status", "--server", "localhost"}), HasSubstr("no port"));
  EXPECT_THAT(refusal({"status", "--server", "localhost:99999"}), HasSubstr("the port must be a number from 1 to 65535"));
  EXPECT_THAT(refusal({"status", "--server", "http://localhost:1"}), HasSubstr("not a URL"));
  EXPECT_THAT(refusal({"status", "--server", "unix:"}), HasSubstr("no path"));
  EXPECT_FALSE(parse({"status", "--server", "localhost:7070"}).leave);
  EXPECT_FALSE(parse({"status", "--server", "[::1]:7070"}).leave);
}

TEST_F(ArgumentsTest, ServerComesFromTheEnvironmentUnlessADatabaseIsNamed) {
  setenv("REGOLAB_SERVER", "host:1234", 1);
  EXPECT_EQ(parse({"status"}).arguments.server, "host:1234");
  EXPECT_EQ(parse({"status", "--db", "x.db"}).arguments.server, "");
  EXPECT_THAT(refusal({"status", "--db", "x.db", "--server", "a:1"}), HasSubstr("--server and --db together"));
}

TEST_F(ArgumentsTest, HelpStartsWithExamplesAndLeavesWithZero) {
  const Parsed parsed = parse({"--help"});
  EXPECT_TRUE(parsed.leave);
  EXPECT_TRUE(parsed.outcome.ok());
  EXPECT_LT(parsed.text.find("Examples:"), parsed.text.find("Usage:"));
}

TEST_F(ArgumentsTest, HintsNameTheSameData) {
  EXPECT_EQ(where_flags(parse({"status"}).arguments), "");
  EXPECT_EQ(where_flags(parse({"status", "--db", "x.db"}).arguments), " --db x.db");
  EXPECT_EQ(where_flags(parse({"status", "--server", "a:1"}).arguments), " --server a:1");
}

}  // namespace
}  // namespace regolab::client
