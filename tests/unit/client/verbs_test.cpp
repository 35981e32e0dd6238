#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "client/json_view.h"
#include "client/program.h"
#include "tests/unit/client/fake_lab.h"
#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// Runs verbs against a scheduler that answers what it was told.
class VerbsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = fs::temp_directory_path() / "regolab-verbs-XXXXXX";
    folder_ = mkdtemp(pattern.data());
    design_ = (folder_ / "a.yaml").string();
    std::ofstream(design_) << "name: sample\n";
    *fake_.judged.mutable_summary() = sample_summary();
    fake_.submitted = fake_.judged;
    fake_.submitted.set_experiment("E1");
    fake_.experiments = {sample_status()};
    fake_.final_status = sample_status("done");
    fake_.results = sample_results();
    fake_.range = sample_range();
    fake_.functions = sample_functions();
  }
  void TearDown() override { fs::remove_all(folder_); }

  int run(std::vector<std::string> words) {
    words.insert(words.end(), {"--server", fake_.address()});
    const Parsed parsed = parse(words);
    EXPECT_FALSE(parsed.leave) << parsed.outcome.text;
    out_.str("");
    err_.str("");
    return run_verb(parsed.arguments, console_);
  }
  Json document() { return Json::parse(out_.str(), nullptr, false); }

  FakeLab fake_;
  fs::path folder_;
  std::string design_;
  std::ostringstream out_;
  std::ostringstream err_;
  Console console_{.out = out_, .err = err_};
};

TEST_F(VerbsTest, EveryVerbAnswersOneNamedJsonDocument) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> all{
      {{"run", design_}, "regolab.run/1"},
      {{"run", design_, "--dry-run"}, "regolab.design/1"},
      {{"submit", design_}, "regolab.submit/1"},
      {{"watch", "last"}, "regolab.watch/1"},
      {{"design", "show", design_}, "regolab.design/1"},
      {{"validate", design_}, "regolab.design/1"},
      {{"status"}, "regolab.status/1"},
      {{"status", "last"}, "regolab.status/1"},
      {{"cancel", "E1"}, "regolab.cancel/1"},
      {{"retry", "E1"}, "regolab.retry/1"},
      {{"results", "E1"}, "regolab.results/1"},
      {{"range", "E1"}, "regolab.range/1"},
      {{"export", "E1", "-o", (folder_ / "export").string()}, "regolab.export/1"},
      {{"article", "check"}, "regolab.article-check/1"},
      {{"article", "compare"}, "regolab.article-compare/1"},
      {{"article", "functions"}, "regolab.article-functions/1"},
      {{"version"}, "regolab.version/1"},
      {{"effects", "ls"}, "regolab.effects/1"},
  };
  for (auto [words, format] : all) {
    words.push_back("--json");
    EXPECT_EQ(run(words), 0) << words[0] << ": " << err_.str();
    ASSERT_TRUE(document().is_object()) << words[0] << ": " << out_.str();
    EXPECT_EQ(document()["format"], format);
  }
}

TEST_F(VerbsTest, FunctionsAreTrainedOnTheArticleUnlessAnExperimentIsNamed) {
  EXPECT_EQ(run({"article", "functions", "--seed", "3"}), 0);
  EXPECT_EQ(fake_.last_training().experiment(), "");
  EXPECT_EQ(fake_.last_training().seed(), 3U);
  EXPECT_THAT(out_.str(), HasSubstr("BP-ANN-1  ours            -       0.988  0.988  0.988"));
  EXPECT_THAT(out_.str(), HasSubstr("article     0.937"));
  EXPECT_THAT(out_.str(), HasSubstr("density     4  0.971"));
  EXPECT_THAT(out_.str(), HasSubstr("split by test, seed 3 (BP-ANN-1)"));
  EXPECT_THAT(out_.str(), HasSubstr("BP-ANN-2 not trained: experiment E1 does not vary K_N (why) remedy"));
  EXPECT_THAT(out_.str(), HasSubstr("note: a note"));
  EXPECT_EQ(run({"article", "functions", "--article"}), 0);
  EXPECT_EQ(fake_.last_training().experiment(), "");
  EXPECT_EQ(run({"article", "functions", "last", "--json"}), 0);
  EXPECT_NE(fake_.last_training().experiment(), "");
  EXPECT_EQ(document()["functions"][0]["outputs"][0]["left_out"]["R"], 0.97125);
  EXPECT_TRUE(document()["functions"][0]["outputs"][0]["left_out"]["R2"].is_null());
  fake_.refusal = {grpc::StatusCode::FAILED_PRECONDITION, "experiment E1 has no sigma1 (why) remedy"};
  EXPECT_EQ(run({"article", "functions", "last"}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("has no sigma1"));
}

TEST_F(VerbsTest, RunShowsTheDesignFollowsAndEndsWithTheRangeAnalysis) {
  EXPECT_EQ(run({"run", design_}), 0);
  EXPECT_THAT(err_.str(), HasSubstr("strength 2 (orthogonal)"));
  EXPECT_THAT(err_.str(), HasSubstr("next: regolab range last"));
  EXPECT_THAT(out_.str(), HasSubstr("theta_F"));
  ASSERT_EQ(fake_.submissions().size(), 1U);
  EXPECT_EQ(fake_.submissions()[0].design_yaml(), "name: sample\n");
}

TEST_F(VerbsTest, RunOfAScatteredDesignNamesTrainingInsteadOfARange) {
  fake_.refusal = {grpc::StatusCode::FAILED_PRECONDITION, "a range analysis needs levels that repeat (why) remedy"};
  fake_.final_status.mutable_summary()->set_error_degrees_of_freedom(-40);
  EXPECT_EQ(run({"run", design_}), 0);
  EXPECT_EQ(out_.str(), "");
  EXPECT_THAT(err_.str(), HasSubstr("no range analysis: a range analysis needs levels that repeat"));
  EXPECT_THAT(err_.str(), HasSubstr("next: regolab train E1"));
  EXPECT_THAT(err_.str(), HasSubstr("next: regolab results E1 --csv -o sample.csv"));
  EXPECT_THAT(err_.str(), Not(HasSubstr("regolab range")));
}

TEST_F(VerbsTest, RunLeavesWithFiveWhenTrialsHaveNoNumbers) {
  fake_.final_status.mutable_jobs()->set_unphysical(3);
  fake_.final_status.add_failures("point 4 seed 1 repose: not settled");
  EXPECT_EQ(run({"run", design_}), 5);
  EXPECT_THAT(err_.str(), HasSubstr("point 4 seed 1 repose: not settled"));
  EXPECT_THAT(err_.str(), HasSubstr("3 jobs without numbers"));
}

TEST_F(VerbsTest, ARejectedDesignShowsEveryProblemAndIsNotSubmitted) {
  for (const char* text : {"unknown key `K_M` (no such parameter) did you mean `K_N`?", "second (why) fix"}) {
    auto* diagnostic = fake_.judged.add_diagnostics();
    diagnostic->set_file(design_);
    diagnostic->set_line(1);
    diagnostic->set_column(1);
    diagnostic->set_source_line("name: sample");
    diagnostic->set_text(text);
  }
  EXPECT_EQ(run({"run", design_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("a.yaml:1:1: unknown key `K_M`"));
  EXPECT_THAT(err_.str(), HasSubstr("2 problems; nothing was changed"));
  EXPECT_TRUE(fake_.submissions().empty());
  EXPECT_EQ(run({"submit", design_, "--json"}), 3);
  EXPECT_EQ(document()["format"], "regolab.diagnostics/1");
  EXPECT_EQ(document()["diagnostics"].size(), 2U);
}

TEST_F(VerbsTest, ExperimentsAreFoundByStartOfIdNameOrLast) {
  fake_.experiments = {sample_status(), sample_status()};
  fake_.experiments[0].set_experiment("abc1");
  fake_.experiments[0].set_created_unix_ms(1);
  fake_.experiments[1].set_experiment("abd2");
  fake_.experiments[1].set_name("other");
  fake_.experiments[1].set_created_unix_ms(2);
  EXPECT_EQ(run({"cancel", "abc"}), 0);
  EXPECT_EQ(fake_.last_cancelled(), "abc1");
  EXPECT_EQ(run({"cancel", "other"}), 0);
  EXPECT_EQ(fake_.last_cancelled(), "abd2");
  EXPECT_EQ(run({"cancel"}), 0);
  EXPECT_EQ(fake_.last_cancelled(), "abd2");
  EXPECT_THAT(err_.str(), HasSubstr("experiment abd2 (other), the last one"));
  EXPECT_EQ(run({"cancel", "ab"}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("it may be abc1 or abd2"));
  EXPECT_EQ(run({"cancel", "zzz"}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("none of that id or name"));
}

TEST_F(VerbsTest, ResultsGoToAFileWholeOrNotAtAll) {
  const std::string file = (folder_ / "r.csv").string();
  EXPECT_EQ(run({"results", "E1", "--csv", "-o", file}), 0);
  std::ifstream in(file);
  std::string header;
  std::getline(in, header);
  EXPECT_THAT(header, HasSubstr("bulk_density_g_per_cm3"));
  EXPECT_EQ(run({"results", "E1", "--csv", "-o", "/nonexistent/r.csv"}), 1);
  EXPECT_THAT(err_.str(), HasSubstr("cannot write /nonexistent/r.csv (No such file or directory)"));
}

TEST_F(VerbsTest, ExportMakesAFolderOnceAndNeverMixes) {
  pb::ExportItem item;
  item.set_point(1);
  item.set_seed(2);
  item.mutable_spec()->set_kind(pb::STAGE_STRESS);
  item.mutable_spec()->set_confining_stress_pa(1250);
  auto* curve = item.mutable_result()->add_curves();
  curve->set_id("sigma1_at_sigma3_1.25kPa");
  curve->set_x_name("axial_strain");
  curve->set_y_name("sigma1");
  curve->set_y_unit_si("Pa");
  curve->add_x_si(0.1);
  curve->add_y_si(5000);
  fake_.items = {item};
  const fs::path target = folder_ / "out";
  EXPECT_EQ(run({"export", "E1", "-o", target.string()}), 0);
  for (const char* file :
       {"results.csv", "stages.csv", "times.csv", "experiment.json", "point-001/seed-2/stress_1.25kPa.json",
        "point-001/seed-2/stress_1.25kPa-sigma1_at_sigma3_1.25kPa.csv"}) {
    EXPECT_TRUE(fs::exists(target / file)) << file;
  }
  EXPECT_EQ(run({"export", "E1", "-o", target.string()}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("exists already"));
}

TEST_F(VerbsTest, WhatTheSchedulerRefusesIsToldWithTheCodeOfItsKind) {
  fake_.refusal = {grpc::StatusCode::FAILED_PRECONDITION, "not the article's design (17 points) run article-l32.yaml"};
  EXPECT_EQ(run({"article", "compare", "E1"}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("not the article's design (17 points) run article-l32.yaml"));
  fake_.refusal = {grpc::StatusCode::RESOURCE_EXHAUSTED, "no room"};
  EXPECT_EQ(run({"range", "E1", "--json"}), 1);
  EXPECT_EQ(document()["format"], "regolab.error/1");
  EXPECT_EQ(document()["exit_code"], 1);
}

TEST_F(VerbsTest, JsonLinesStreamsEvents) {
  for (std::uint64_t seq = 1; seq <= 2; ++seq) {
    pb::WatchEvent event;
    event.set_seq(seq);
    *event.mutable_status() = sample_status();
    fake_.events.push_back(event);
  }
  EXPECT_EQ(run({"watch", "E1", "--json-lines"}), 0);
  std::istringstream lines(out_.str());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_EQ(Json::parse(line)["seq"], count + 1);
  EXPECT_EQ(count, 2);
}

}  // namespace
}  // namespace regolab::client
