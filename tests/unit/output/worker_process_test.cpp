/// The worker program itself: killed, interrupted and started again, it ends with the same numbers.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "unit/output/temporary_folder.h"
#include "worker/output/atomic_file.h"
#include "worker/output/run_command.h"

namespace regolab {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kJob = R"(profile: quick
seed: 3
particles: 60
box: {length: 2.2 cm, width: 2.0 cm}
micro: {theta_F: 30 degree, K_N: 5e4 N/m, eta_N: 0.5 N.s/m, K_T: 5e4 N/m, eta_T: 0.5 N.s/m, L_S: 1 cm, N_E: 4, rotation: xz}
tests: [settle, repose]
)";

class WorkerProcessTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(write_whole_file(folder_ / "job.yaml", kJob).ok()); }

  pid_t start(const std::string& out) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const std::string job = (folder_ / "job.yaml").string(), directory = (folder_.path() / out).string();
    ::execl(REGOLAB_WORKER, "regolab-worker", "run", job.c_str(), "--out", directory.c_str(), "--checkpoint-every", "1ms",
            "--quiet", nullptr);
    ::_exit(127);
  }

  /// When the newest checkpoint was written; the epoch when there is none.
  fs::file_time_type newest_checkpoint(const std::string& out) const {
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder_.path() / out / ".checkpoint", code)) {
      if (entry.path().extension() == ".partial") newest = std::max(newest, fs::last_write_time(entry, code));
    }
    return newest;
  }

  /// Until a checkpoint newer than `before` stands there (the process is at work, its signal handling too), or the results.
  void wait_for_checkpoint(const std::string& out, fs::file_time_type before) const {
    for (int look = 0; look < 6000 && newest_checkpoint(out) <= before; ++look) {
      if (fs::exists(folder_.path() / out / "result.json")) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  static int wait(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  /// The result without what time it took, and how many steps the last start did.
  Json result(const std::string& out) const {
    Json json = Json::parse(read_whole_file(folder_.path() / out / "result.json").value());
    for (Json& stage : json["stages"]) {
      stage.erase("wall_s");
      stage.erase("steps");
    }
    return json;
  }

  test::TemporaryFolder folder_;
};

TEST_F(WorkerProcessTest, KilledAndInterruptedAgainAndAgainEndsWithTheSameNumbers) {
  ASSERT_EQ(wait(start("whole")), kExitDone);
  for (int cut = 0; cut < 4; ++cut) {
    const auto before = newest_checkpoint("cut");
    const pid_t child = start("cut");
    wait_for_checkpoint("cut", before);
    std::this_thread::sleep_for(std::chrono::milliseconds(30 * cut));
    const int signal = cut % 2 == 0 ? SIGKILL : SIGINT;
    ::kill(child, signal);
    const int code = wait(child);
    if (fs::exists(folder_.path() / "cut/result.json")) continue;  // it was quicker: the signal met a program that had all done
    EXPECT_EQ(code, signal == SIGKILL ? -SIGKILL : static_cast<int>(kExitInterrupted));
  }
  ASSERT_EQ(wait(start("cut")), kExitDone);
  EXPECT_EQ(result("cut"), result("whole"));
  for (const char* name : {"bed.vtp", "contacts.vtp", "repose.xyz", "observations.yaml"}) {
    EXPECT_EQ(*read_whole_file(folder_.path() / "cut" / name), *read_whole_file(folder_.path() / "whole" / name)) << name;
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "cut/.checkpoint"));
}

TEST_F(WorkerProcessTest, WithoutAJobIsUsage) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(REGOLAB_WORKER, "regolab-worker", "run", nullptr);
    ::_exit(127);
  }
  EXPECT_EQ(wait(child), kExitUsage);
}

}  // namespace
}  // namespace regolab
