/// Sets of blind cases: what is committed to and when, what a kill leaves, what is found when something was changed.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "client/blind/folder.h"
#include "client/blind/key_file.h"
#include "client/blind/pace.h"
#include "client/json_view.h"
#include "client/program.h"
#include "digest/sha256.h"
#include "seal/seal.h"
#include "tests/unit/client/fake_lab.h"
#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

class BlindTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = fs::temp_directory_path() / "regolab-blind-XXXXXX";
    place_ = mkdtemp(pattern.data());
    set_ = (place_ / "set").string();
    fake_.submitted.set_experiment("E1");
    fake_.experiments = {sample_status("done")};
    fake_.final_status = sample_status("done");
  }
  void TearDown() override { fs::remove_all(place_); }

  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"gap", "blind"});
    words.insert(words.end(), {"--server", fake_.address()});
    const Parsed parsed = parse(words);
    EXPECT_FALSE(parsed.leave) << parsed.outcome.text;
    out_.str(""), err_.str("");
    return run_verb(parsed.arguments, console_);
  }
  int make(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"make", set_, "--cases", "2", "--nulls", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  static std::string text(const fs::path& file) {
    std::ostringstream out;
    out << std::ifstream(file, std::ios::binary).rdbuf();
    return out.str();
  }
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  fs::path in_set(const std::string& name) const { return fs::path(set_) / name; }
  std::size_t files_in(const std::string& name) const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(in_set(name)), {})); }

  /// An answer as a solver gives it.
  void answer(const std::string& id) {
    BlindFolder folder(set_);
    ASSERT_TRUE(folder.lock(false).ok());
    ASSERT_TRUE(folder.read().ok());
    const Json j{{"verdict", "NO GAP"}, {"classes", Json::array()}, {"provenance", {{"measurements", sha256_hex(text(folder.case_file(id)))}}}};
    ASSERT_TRUE(folder.add_answer(id, j.dump()).ok());
  }
  void answer_all() { answer("case0"), answer("case1"), answer("case2"); }

  FakeLab fake_;
  fs::path place_;
  std::string set_;
  std::ostringstream out_, err_;
  Console console_{.out = out_, .err = err_};
};

TEST_F(BlindTest, CommitsToEveryTruthBeforeAnythingRuns) {
  bool committed = true;
  fake_.blind.on_design = [&] { committed = committed && fs::exists(in_set("commitments")) && fs::exists(in_set("set.json")); };
  ASSERT_EQ(make(), 0) << err_.str();
  EXPECT_TRUE(committed);
  EXPECT_EQ(fake_.blind.observed, 3);
  const std::string commitments = text(in_set("commitments"));
  for (int k = 0; k < 3; ++k) EXPECT_THAT(commitments, HasSubstr(sha256_hex(FakeBlind::truth_of(k)) + "  case" + std::to_string(k) + ".json\n"));
  const auto lines = commitments.substr(0, commitments.find("# SHA-256 of the lines above"));
  EXPECT_THAT(err_.str(), HasSubstr(sha256_hex(lines))) << "what to publish";
}

TEST_F(BlindTest, ShowsNothingOfTheTruthBeforeTheReveal) {
  ASSERT_EQ(make(), 0);
  std::set<std::uintmax_t> sizes;
  for (const auto& file : fs::recursive_directory_iterator(set_)) {
    if (!file.is_regular_file()) continue;
    EXPECT_THAT(text(file.path()), Not(HasSubstr("cohesion"))) << file.path();
    if (file.path().parent_path().filename() == "sealed") sizes.insert(file.file_size());
  }
  EXPECT_EQ(sizes.size(), 1U) << "sizes would tell kinds apart";
  EXPECT_THAT(err_.str() + out_.str(), Not(HasSubstr("cohesion of")));
}

TEST_F(BlindTest, GoesOnWhereItWasKilled) {
  fake_.blind.fail_observing_after = 1;
  EXPECT_NE(make(), 0);
  EXPECT_EQ(files_in("cases"), 1U);
  const std::string before = text(in_set("commitments"));
  fake_.blind.fail_observing_after = -1;
  ASSERT_EQ(make(), 0) << err_.str();
  EXPECT_EQ(files_in("cases"), 3U);
  EXPECT_EQ(fake_.blind.drawn, 1) << "truths are drawn once";
  EXPECT_EQ(fake_.blind.observed, 3) << "what is measured is not measured again";
  EXPECT_EQ(text(in_set("commitments")), before);
  ASSERT_EQ(make(), 0);
  EXPECT_EQ(fake_.blind.observed, 3);
}

TEST_F(BlindTest, AKillBeforeTheSetIsWholeLeavesNone) {
  ASSERT_EQ(make({"--only", "1"}), 0);
  fs::remove(in_set("set.json")), fs::remove(in_set("commitments"));  // written last
  ASSERT_EQ(make(), 0) << err_.str();
  EXPECT_EQ(fake_.blind.drawn, 2);
}

TEST_F(BlindTest, MakesAsManyAsAskedFor) {
  ASSERT_EQ(make({"--only", "2", "--json"}), 0);
  const Json j = Json::parse(out_.str());
  EXPECT_EQ(j["measured"], 2);
  EXPECT_EQ(j["cases"], 3);
}

TEST_F(BlindTest, TheKeyIsItsOwnersAlone) {
  ASSERT_EQ(make(), 0);
  struct stat about {};
  ASSERT_EQ(stat((set_ + ".key").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0600U);
  answer_all();
  fs::permissions(set_ + ".key", fs::perms::others_read, fs::perm_options::add);
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("chmod 600"));
}

TEST_F(BlindTest, AKeyOrADatabaseInTheSetsFolderIsRefused) {
  EXPECT_EQ(make({"--key", set_ + "/my.key"}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("lies in the set's folder"));
  EXPECT_TRUE(lies_in(set_ + "/a/b", set_));
  EXPECT_TRUE(lies_in(set_ + "/../set/x", set_));
  EXPECT_FALSE(lies_in(set_ + ".key", set_));
}

TEST_F(BlindTest, AnotherSetOrOtherFilesAreNotMixedIn) {
  ASSERT_EQ(make(), 0);
  EXPECT_EQ(run({"make", set_, "--cases", "5"}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("another set"));
  EXPECT_EQ(make({"--seed", "4"}), 2) << "a blind set does not become a development set";
  fs::create_directories(place_ / "mine");
  write(place_ / "mine" / "notes.txt", "mine");
  EXPECT_EQ(run({"make", (place_ / "mine").string()}), 3);
}

TEST_F(BlindTest, TwoAtATimeAreRefused) {
  ASSERT_EQ(make(), 0);
  BlindFolder other(set_);
  ASSERT_TRUE(other.lock(false).ok());
  EXPECT_EQ(run({"reveal", set_}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("in use"));
}

TEST_F(BlindTest, DevelopmentIsWrittenOnEveryList) {
  ASSERT_EQ(make({"--seed", "7"}), 0);
  EXPECT_EQ(Json::parse(text(in_set("set.json")))["development"], true);
  EXPECT_THAT(text(in_set("commitments")), HasSubstr("# development set, seed 7"));
  answer("case0");
  EXPECT_THAT(text(in_set("answers")), HasSubstr("# development set"));
  EXPECT_THAT(out_.str(), HasSubstr("DEVELOPMENT"));
}

TEST_F(BlindTest, RevealsOnlyWhenAllIsAnswered) {
  ASSERT_EQ(make(), 0);
  EXPECT_EQ(run({"reveal", set_}), 2);
  answer("case1");
  EXPECT_EQ(run({"reveal", set_}), 2);
  EXPECT_THAT(err_.str(), HasSubstr("2 of 3 cases have no answer"));
  EXPECT_FALSE(fs::exists(in_set("truths")));
  answer("case0"), answer("case2");
  ASSERT_EQ(run({"reveal", set_}), 0) << err_.str();
  ASSERT_EQ(fake_.blind.scored.size(), 4U) << "the bank, then the cases";
  EXPECT_EQ(fake_.blind.scored[0].missing(), 0U);
  EXPECT_EQ(fake_.blind.scored[1].observations(), "observations of case0\n");
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(text(in_set("truths/case" + std::to_string(k) + ".json")), FakeBlind::truth_of(k)) << "as committed to, byte by byte";
  EXPECT_TRUE(fs::exists(in_set("record.csv")) && fs::exists(in_set("score.json")));
}

TEST_F(BlindTest, APartOfTheAnswersOpensAPartOfTheTruths) {
  ASSERT_EQ(make(), 0);
  answer("case1");
  ASSERT_EQ(run({"reveal", set_, "--partial"}), 0) << err_.str();
  EXPECT_EQ(fake_.blind.scored[0].missing(), 2U);
  EXPECT_EQ(files_in("truths"), 1U);
  EXPECT_TRUE(fs::exists(in_set("truths/case1.json")));
}

TEST_F(BlindTest, AnotherKeyOpensNothing) {
  ASSERT_EQ(make(), 0);
  answer_all();
  write(place_ / "other.key", std::string(64, 'a') + "\n");
  fs::permissions(place_ / "other.key", fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(run({"reveal", set_, "--key", (place_ / "other.key").string()}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("another key"));
  EXPECT_FALSE(fs::exists(in_set("truths")));
}

TEST_F(BlindTest, AChangedTruthIsFound) {
  ASSERT_EQ(make(), 0);
  answer_all();
  std::string key;
  ASSERT_TRUE(read_key(set_ + ".key", set_, key).ok());
  write(in_set("sealed/case1"), *sealed(key, "{\"truth\": \"what I would rather have drawn\"}\n", "case1"));
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("case1: the truth is not the one committed to"));
}

TEST_F(BlindTest, AChangedCommitmentIsFound) {
  ASSERT_EQ(make(), 0);
  answer_all();
  std::string list = text(in_set("commitments"));
  list.replace(list.find(sha256_hex(FakeBlind::truth_of(1))), 64, sha256_hex("another"));
  write(in_set("commitments"), list);
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("it was changed"));
}

TEST_F(BlindTest, AChangedAnswerOrCaseIsFound) {
  ASSERT_EQ(make(), 0);
  answer_all();
  const std::string good = text(in_set("cases/case2.answer.json"));
  write(in_set("cases/case2.answer.json"), good + " ");
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("one answer to a case"));
  write(in_set("cases/case2.answer.json"), good);
  write(in_set("cases/case2.yaml"), "easier observations\n");
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("changed after it was answered"));
}

TEST_F(BlindTest, ASecondAnswerIsRefused) {
  ASSERT_EQ(make(), 0);
  answer_all();
  answer("case1");
  EXPECT_EQ(run({"reveal", set_}), 3);
  EXPECT_THAT(err_.str(), HasSubstr("stands twice"));
}

TEST_F(BlindTest, ATornLineOfAnswersDoesNotCount) {
  ASSERT_EQ(make(), 0);
  answer("case0");
  const std::string whole = text(in_set("answers"));
  std::ofstream(in_set("answers"), std::ios::app) << sha256_hex("x").substr(0, 20);
  BlindFolder folder(set_);
  ASSERT_TRUE(folder.lock(false).ok() && folder.read().ok());
  EXPECT_EQ(folder.answers().size(), 1U);
  ASSERT_TRUE(folder.add_answer("case1", "{}").ok());
  ASSERT_TRUE(folder.read().ok());
  EXPECT_EQ(folder.answers().size(), 2U);
  EXPECT_EQ(folder.answers()[1].sha256, sha256_hex("{}"));
}

TEST_F(BlindTest, MeasuredShrinkageIsTakenAlong) {
  ASSERT_EQ(make(), 0);
  answer_all();
  write(in_set("cases/case1.shrinkage.json"), R"({"S": 0.8})");
  ASSERT_EQ(run({"reveal", set_}), 0);
  EXPECT_EQ(fake_.blind.scored[2].shrinkage(), R"({"S": 0.8})");
}

TEST(Pace, SaysWhatIsLeft) {
  Pace pace(10);
  EXPECT_EQ(pace.text_after(60), "0 of 10 done");
  for (int k = 0; k < 5; ++k) pace.one_done();
  EXPECT_EQ(pace.text_after(3600), "5 of 10 done, 5 cases/h, about 60 min left");
  EXPECT_EQ(pace.text_after(60), "5 of 10 done, 300 cases/h, about 60 s left");
  for (int k = 0; k < 5; ++k) pace.one_done();
  EXPECT_EQ(pace.text_after(3600), "10 of 10 done, 10 cases/h");
}

}  // namespace
}  // namespace regolab::client
