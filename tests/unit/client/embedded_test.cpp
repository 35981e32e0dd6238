#include "client/embedded.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <thread>

namespace regolab::client {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Shell scripts stand in for the scheduler and the worker.
class EmbeddedTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = fs::temp_directory_path() / "regolab-embedded-XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  void program(const std::string& name, const std::string& body) {
    std::ofstream(folder_ / name) << "#!/bin/sh\n" << body;
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }
  Embedded::Options options() { return {.programs = folder_, .database = folder_ / "a.db"}; }
  std::string counted(const std::string& file) {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Waits for something a child does; the limit only bounds a failing test.
  static bool eventually(const std::function<bool()>& true_now) {
    for (int i = 0; i < 500; ++i) {
      if (true_now()) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

  static constexpr const char* kReady = "echo \"listening on $4\"; exec sleep 100\n";
  fs::path folder_;
};

TEST_F(EmbeddedTest, StartsASchedulerOnAPrivateSocketAndLeavesNothingBehind) {
  program("regolab-scheduler", "echo \"$@\" > " + (folder_ / "words").string() + "\n" + kReady);
  std::unique_ptr<Embedded> embedded;
  ASSERT_TRUE(Embedded::start(options(), embedded).ok());
  const fs::path scratch = fs::path(embedded->address().substr(5)).parent_path();
  struct stat info {};
  ASSERT_EQ(stat(scratch.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0700U);
  EXPECT_EQ(counted("words"),
            "--db " + (folder_ / "a.db").string() + " --listen " + embedded->address() + " --exit-with-parent\n");
  embedded.reset();
  EXPECT_FALSE(fs::exists(scratch));
  EXPECT_FALSE(fs::exists(folder_ / "a.db.d" / "address"));
}

TEST_F(EmbeddedTest, ARefusalIsPassedOnWithItsWordsAndItsCode) {
  program("regolab-scheduler",
          "echo '[info] opening' >&2; echo 'regolab-scheduler: a.db: version 9 (newer than this program) update it' >&2; "
          "exit 3\n");
  std::unique_ptr<Embedded> embedded;
  const Outcome outcome = Embedded::start(options(), embedded);
  EXPECT_EQ(outcome.exit, Exit::kInvalidInput);
  EXPECT_EQ(outcome.text, "a.db: version 9 (newer than this program) update it");
  EXPECT_EQ(embedded, nullptr);
}

TEST_F(EmbeddedTest, AMissingProgramIsTold) {
  std::unique_ptr<Embedded> embedded;
  EXPECT_THAT(Embedded::start(options(), embedded).text,
              HasSubstr("cannot start " + (folder_ / "regolab-scheduler").string()));
}

TEST_F(EmbeddedTest, AKilledWorkerIsStartedAgain) {
  program("regolab-scheduler", kReady);
  program("regolab-worker", "echo $$ >> " + (folder_ / "pids").string() + "; exec sleep 100\n");
  std::unique_ptr<Embedded> embedded;
  ASSERT_TRUE(Embedded::start(options(), embedded).ok());
  embedded->have_workers(1);
  ASSERT_TRUE(eventually([&] { return !counted("pids").empty(); }));
  kill(std::stoi(counted("pids")), SIGKILL);
  EXPECT_TRUE(eventually([&] {
    const auto pids = counted("pids");
    return std::count(pids.begin(), pids.end(), '\n') == 2;
  }));
  EXPECT_FALSE(embedded->broken().stop_requested());
}

TEST_F(EmbeddedTest, AKilledSchedulerIsStartedAgainButOneThatEndsByItselfIsTheEnd) {
  program("regolab-scheduler", "echo $$ >> " + (folder_ / "pids").string() + "\n[ $(wc -l < " + (folder_ / "pids").string() +
                                   ") = 2 ] && { echo 'disk gone' >&2; exit 1; }\n" + kReady);
  std::unique_ptr<Embedded> embedded;
  ASSERT_TRUE(Embedded::start(options(), embedded).ok());
  kill(std::stoi(counted("pids")), SIGKILL);
  ASSERT_TRUE(eventually([&] { return embedded->broken().stop_requested(); }));
  EXPECT_EQ(embedded->failure().exit, Exit::kInternal);
  EXPECT_THAT(embedded->failure().text, HasSubstr("regolab-scheduler ended (exit code 1):\ndisk gone"));
}

TEST_F(EmbeddedTest, WorkersAreAskedToLeaveBeforeTheScheduler) {
  const std::string order = (folder_ / "order").string();
  const std::string trap = "trap 'echo NAME >> " + order + "; exit 0' TERM\n";
  const auto named = [&](const std::string& name) { return std::string(trap).replace(trap.find("NAME"), 4, name); };
  program("regolab-scheduler", named("scheduler") + "echo listening on x\nwhile :; do sleep 0.05; done\n");
  program("regolab-worker", named("worker") + "echo up > " + (folder_ / "up").string() + "\nwhile :; do sleep 0.05; done\n");
  std::unique_ptr<Embedded> embedded;
  ASSERT_TRUE(Embedded::start(options(), embedded).ok());
  embedded->have_workers(1);
  ASSERT_TRUE(eventually([&] { return !counted("up").empty(); }));
  embedded.reset();
  EXPECT_EQ(counted("order"), "worker\nscheduler\n");
}

TEST_F(EmbeddedTest, NobodyIsFoundBehindAStaleAnnouncement) {
  fs::create_directories(folder_ / "a.db.d");
  std::ofstream(folder_ / "a.db.d" / "address") << "unix:/nonexistent/socket\n";
  EXPECT_EQ(running_scheduler_of(folder_ / "a.db"), "");
}

}  // namespace
}  // namespace regolab::client
