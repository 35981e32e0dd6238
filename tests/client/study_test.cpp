/// A right design, as far as it goes without waiting for physics.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/client/programs.h"

namespace regolab {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Study : public Programs {
 protected:
  void SetUp() override {
    Programs::SetUp();
    write("a.yaml", good_design());
  }
};

TEST_F(Study, DryRunShowsTheDesignAndMakesNothing) {
  const Ran ran = regolab("run a.yaml --dry-run");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("4 points x 1 seed, strength 2 (orthogonal), balanced"));
  EXPECT_THAT(ran.out, HasSubstr("8 stages, 0 stored already, 4 DEM runs to do"));
  EXPECT_THAT(listing(), ElementsAre("a.yaml"));
}

TEST_F(Study, SubmittedExperimentsAreThereForEveryVerb) {
  const Ran submitted = regolab("submit a.yaml");
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string id = submitted.out.substr(0, submitted.out.find('\n'));
  EXPECT_THAT(regolab("status").out, HasSubstr(id));
  EXPECT_THAT(regolab("status " + id.substr(0, 6)).out, HasSubstr("experiment " + id + " (four): running"));
  const auto results = json::parse(regolab("results last --json").out);
  EXPECT_EQ(results["rows"].size(), 4U);
  EXPECT_TRUE(results["rows"][0]["bulk_density_g_per_cm3"].is_null());
  EXPECT_THAT(results["rows"][0]["missing"]["bulk_density"].get<std::string>(), HasSubstr("pending"));
  const auto again = json::parse(regolab("submit a.yaml --json").out);
  EXPECT_EQ(again["experiment"], id);
  EXPECT_EQ(again["already_known"], true);
  EXPECT_EQ(regolab("cancel last").code, 0);
  EXPECT_THAT(regolab("status last").out, HasSubstr("cancelled"));
  EXPECT_EQ(regolab("retry last").code, 0);
  EXPECT_THAT(regolab("status last").out, HasSubstr("running"));
}

TEST_F(Study, ATimeoutLeavesWithSixAndKeepsTheExperiment) {
  write("long.yaml", spoiled(good_design(), "particles: 120", "particles: 5000"));
  const Ran ran = regolab("run long.yaml --timeout 1 --workers 1");
  EXPECT_EQ(ran.code, 6) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("not done after 1 s (--timeout)"));
  EXPECT_THAT(regolab("status").out, HasSubstr("running"));
}

TEST_F(Study, AnInterruptLeavesWithHundredThirtyAndSaysHowToGoOn) {
  write("long.yaml", spoiled(good_design(), "particles: 120", "particles: 5000"));
  const Ran ran = shell("timeout --foreground -s INT 2 $regolab run long.yaml --workers 1; exit $?");
  EXPECT_THAT(ran.err,
              HasSubstr("interrupted (what was finished is in regolab.db) go on with `regolab run long.yaml --workers 1`"));
  EXPECT_THAT(regolab("status").out, HasSubstr("running"));
}

TEST_F(Study, ASecondClientFindsTheSchedulerOfTheFirst) {
  write("long.yaml", spoiled(good_design(), "particles: 120", "particles: 5000"));
  const Ran ran = shell(
      "$regolab run long.yaml --workers 1 2>first.err & first=$!\n"
      "for i in $(seq 100); do [ -s regolab.db.d/address ] && break; sleep 0.1; done\n"
      "sleep 0.3; $regolab status; code=$?; kill -INT $first; wait $first; exit $code");
  EXPECT_EQ(ran.code, 0) << ran.err << read("first.err");
  EXPECT_THAT(ran.out, HasSubstr("four"));
}

TEST_F(Study, TheArticlesOwnTablesNeedNoDatabase) {
  const Ran ran = regolab("article check --json");
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto document = json::parse(ran.out);
  EXPECT_EQ(document["format"], "regolab.article-check/1");
  EXPECT_GE(document["entries"].size(), 56U);
  const Ran range = regolab("range --article --without 3 --without 27 --csv --response repose_angle");
  EXPECT_EQ(range.code, 0) << range.err;
  EXPECT_THAT(range.out, HasSubstr("\nrepose_angle,deg,30,"));
  EXPECT_THAT(listing(), ElementsAre("a.yaml"));
}

TEST_F(Study, ComparingAStudyThatIsNotTheArticlesIsRefused) {
  ASSERT_EQ(regolab("submit a.yaml").code, 0);
  const Ran ran = regolab("article compare last");
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("article"));
}

TEST_F(Study, TheShippedExamplesAreRight) {
  const Ran article = regolab("design show " REGOLAB_SOURCE "/client/examples/article-l32.yaml");
  EXPECT_EQ(article.code, 0) << article.err;
  EXPECT_THAT(article.out, HasSubstr("32 points x 1 seed, strength 2 (orthogonal), balanced, 7 error degrees of freedom"));
  EXPECT_EQ(regolab("design show " REGOLAB_SOURCE "/client/examples/small-l4.yaml").code, 0);
}

}  // namespace
}  // namespace regolab
