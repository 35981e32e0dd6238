#include "client/follow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/unit/client/fake_lab.h"
#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

pb::WatchEvent event(std::uint64_t seq, const std::string& text) {
  pb::WatchEvent out;
  out.set_seq(seq);
  out.set_text(text);
  *out.mutable_status() = sample_status();
  return out;
}

class FollowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fake_.events = {event(1, "one"), event(2, "two"), event(3, "three")};
    fake_.final_status = sample_status("done");
    options_.on_event = [this](const pb::WatchEvent& e) { seen_.push_back(e.text()); };
  }

  FakeLab fake_;
  Lab lab_{{.address = fake_.address()}};
  FollowOptions options_;
  std::vector<std::string> seen_;
  std::ostringstream out_;
  std::ostringstream err_;
  Console console_{.out = out_, .err = err_};
  pb::ExperimentStatus last_;
};

TEST_F(FollowTest, SeesEveryEventAndEndsWithTheExperiment) {
  ASSERT_TRUE(follow(lab_, "E1", options_, console_, last_).ok());
  EXPECT_THAT(seen_, ElementsAre("one", "two", "three"));
  EXPECT_EQ(last_.state(), "done");
  EXPECT_EQ(options_.from_seq, 4U);
}

TEST_F(FollowTest, ALostStreamGoesOnAfterTheLastEventSeen) {
  fake_.break_after = 2;
  ASSERT_TRUE(follow(lab_, "E1", options_, console_, last_).ok());
  EXPECT_THAT(seen_, ElementsAre("one", "two", "three"));
  EXPECT_THAT(fake_.watched_from(), ElementsAre(0, 3));
  EXPECT_THAT(err_.str(), HasSubstr("connection to the scheduler lost; trying again"));
}

TEST_F(FollowTest, HeartbeatsAreNoEvents) {
  auto beat = event(2, "");
  beat.set_progress_only(true);
  fake_.events = {event(1, "one"), event(2, "two"), beat};
  ASSERT_TRUE(follow(lab_, "E1", options_, console_, last_).ok());
  EXPECT_THAT(seen_, ElementsAre("one", "two"));
}

TEST_F(FollowTest, GivesUpWhenTheSchedulerStaysAway) {
  Lab nowhere({.address = "unix:/nonexistent/socket"});
  options_.patience = std::chrono::seconds(0);
  const Outcome outcome = follow(nowhere, "E1", options_, console_, last_);
  EXPECT_EQ(outcome.exit, Exit::kUnreachable);
  EXPECT_THAT(outcome.text, HasSubstr("no scheduler at unix:/nonexistent/socket (unix:/nonexistent/socket: No such file"));
}

TEST_F(FollowTest, VerdictCountsWhatHasNoNumbers) {
  auto status = sample_status("done");
  EXPECT_TRUE(verdict_of(status).ok());
  status.mutable_jobs()->set_unphysical(2);
  status.mutable_jobs()->set_skipped(1);
  EXPECT_EQ(verdict_of(status).exit, Exit::kTrialsFailed);
  EXPECT_THAT(verdict_of(status).text, HasSubstr("3 jobs without numbers"));
}

}  // namespace
}  // namespace regolab::client
