#include "client/progress.h"

#include <gtest/gtest.h>

#include <sstream>

#include "client/table_print.h"
#include "tests/unit/client/samples.h"

namespace regolab::client {
namespace {

using namespace std::chrono_literals;

/// A clock the test moves by hand.
struct HandClock {
  std::chrono::steady_clock::time_point now{};
  ProgressLine::Clock clock() {
    return [this] { return now; };
  }
};

TEST(Progress, SaysDoneRunningFailedRateTimeLeftAndPhase) {
  EXPECT_EQ(progress_text(sample_status(), 0.5, 200),
            "sample  37/224 done, 2 running, 0 failed, 30 jobs/min, about 12 min left | settle sedimentation 43 %, 8.4 "
            "M sphere-steps/s");
}

TEST(Progress, SaysWhenNobodyWorks) {
  auto status = sample_status();
  status.set_workers(0);
  EXPECT_NE(progress_text(status, std::nullopt, 200).find("no workers"), std::string::npos);
}

TEST(Progress, IsCutToTheTerminal) {
  const std::string text = progress_text(sample_status(), 0.5, 40);
  EXPECT_EQ(display_width(text), 40);
  EXPECT_TRUE(text.ends_with("…"));
}

TEST(Progress, SkippedAndQuarantinedJobsCountAsFailed) {
  pb::JobCounts jobs;
  jobs.set_failed(1);
  jobs.set_skipped(2);
  jobs.set_quarantined(3);
  jobs.set_succeeded(4);
  EXPECT_EQ(progress_of(jobs).failed, 6U);
  EXPECT_EQ(progress_of(jobs).total, 10U);
}

TEST(Progress, WritesAPlainLineEveryThirtySecondsWhenNotOnATerminal) {
  std::ostringstream out;
  std::ostringstream err;
  Console console{.out = out, .err = err};
  HandClock hand;
  ProgressLine line(console, hand.clock());
  auto status = sample_status();
  for (int second = 0; second <= 60; ++second) {
    status.mutable_jobs()->set_succeeded(static_cast<unsigned>(37 + second));
    line.show(status);
    hand.now += 1s;
  }
  const std::string text = err.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find("97/284 done"), std::string::npos) << text;
  EXPECT_NE(text.find("60 jobs/min"), std::string::npos) << text;
}

TEST(Progress, RewritesOneLineOnATerminalAndTakesItAway) {
  std::ostringstream out;
  std::ostringstream err;
  Console console{.out = out, .err = err, .live = true, .width = 60};
  {
    ProgressLine line(console);
    line.show(sample_status());
    EXPECT_EQ(err.str().find('\n'), std::string::npos);
    line.say("point 3 done");
    EXPECT_NE(err.str().find("point 3 done\n"), std::string::npos);
    line.show(sample_status());
  }
  EXPECT_TRUE(err.str().ends_with("\r\x1b[K"));
}

}  // namespace
}  // namespace regolab::client
