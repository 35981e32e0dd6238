/// One fault at a time, with the programs themselves.
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "audit.h"
#include "processes.h"
#include "store/migrate.h"
#include "support/lab_client.h"
#include "support/temp_dir.h"

namespace regolab::test {
namespace {

using testing::HasSubstr;

struct FaultsTest : testing::Test {
  Programs programs;
  TempDir dir;
  std::string database = dir / "lab.db", address = "unix:" + (dir / "socket"), log = dir / "log";

  Command scheduler(const std::vector<std::string>& more = {}) {
    Command command{programs.scheduler, "--db", database, "--listen", address, "--lease-ttl", "1s"};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }
  Command worker(const std::string& stage_time, const std::vector<std::string>& more = {}) {
    Command command{REGOLAB_FAKE_WORKER, "serve", "--server", address, "--stage-time", stage_time};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }
  bool ready() {
    return eventually([&] { return text_of(log).find("listening on") != std::string::npos; });
  }
  /// Runs to its end: exit code and what it said.
  std::pair<int, std::string> outcome(const Command& command) {
    const std::string own_log = dir / "outcome.log";
    std::filesystem::remove(own_log);
    Process process{command, own_log};
    const int code = process.wait();
    return {code, text_of(own_log)};
  }
};

TEST_F(FaultsTest, APortInUseIsExitCodeFourAndSaysWhatToDo) {
  address = "127.0.0.1:0";
  Process first{scheduler(), log};
  ASSERT_TRUE(ready());
  const std::string text = text_of(log);
  const std::string bound = text.substr(text.find("127."), text.find('\n', text.find("127.")) - text.find("127."));
  EXPECT_THAT(bound, testing::Not(HasSubstr(":0")));
  const auto [code, said] = outcome({programs.scheduler, "--db", dir / "other.db", "--listen", bound});
  EXPECT_EQ(code, 4);
  EXPECT_THAT(said, HasSubstr("cannot listen on " + bound + " (the address is in use)"));
  EXPECT_FALSE(std::filesystem::exists(dir / "other.db"));
}

TEST_F(FaultsTest, ABadAddressIsExitCodeTwo) {
  for (const char* bad : {"nonsense", "localhost:99999"}) {
    const auto [code, said] = outcome({programs.scheduler, "--db", database, "--listen", bad});
    EXPECT_EQ(code, 2) << said;
    EXPECT_THAT(said, HasSubstr("give --listen host:port"));
  }
  EXPECT_EQ(outcome({programs.scheduler, "--db", database, "--lease-ttl", "15"}).first, 2) << "a time needs its unit";
  EXPECT_EQ(outcome({programs.scheduler}).first, 2);
  EXPECT_EQ(outcome({programs.scheduler, "--help"}).first, 0);
}

TEST_F(FaultsTest, ALockedDatabaseIsExitCodeThree) {
  Process first{scheduler(), log};
  ASSERT_TRUE(ready());
  const auto [code, said] = outcome({programs.scheduler, "--db", database, "--listen", "unix:" + (dir / "second")});
  EXPECT_EQ(code, 3);
  EXPECT_THAT(said, HasSubstr("the database is in use"));
}

TEST_F(FaultsTest, ANewerDatabaseIsExitCodeThreeAndUntouched) {
  {
    auto db = Database::open(database, Access::kWrite);
    const std::string header =
        "PRAGMA application_id=" + std::to_string(kApplicationId) + "; PRAGMA user_version=77; CREATE TABLE t (x)";
    ASSERT_TRUE(db->run(header.c_str(), "make").ok());
  }
  const std::string before = text_of(database);
  const auto [code, said] = outcome(scheduler());
  EXPECT_EQ(code, 3);
  EXPECT_THAT(said, HasSubstr("newer regolab (schema 77"));
  EXPECT_EQ(text_of(database), before);
}

TEST_F(FaultsTest, AFileThatIsNoDatabaseIsExitCodeThree) {
  std::ofstream(database) << std::string(4096, 'x');
  const auto [code, said] = outcome(scheduler());
  EXPECT_EQ(code, 3);
  EXPECT_THAT(said, HasSubstr("file is not a database"));
  const auto [folder_code, folder_said] = outcome({programs.scheduler, "--db", dir / "no/such/lab.db", "--listen", address});
  EXPECT_EQ(folder_code, 3);
  EXPECT_THAT(folder_said, HasSubstr("check that the folder exists"));
}

TEST_F(FaultsTest, APausedWorkerIsFencedWhenItComesBack) {
  Process server{scheduler(), log};
  ASSERT_TRUE(ready());
  LabClient client{address};
  const auto submitted = client.submit(l4_yaml(1));
  Process slow{worker("500ms"), dir / "slow.log"};
  ASSERT_TRUE(eventually([&] { return client.status(submitted.experiment()).running_size() == 1; }));
  slow.signal(SIGSTOP);
  const auto held = client.status(submitted.experiment()).running(0);
  Process quick{worker("20ms"), dir / "quick.log"};
  ASSERT_TRUE(eventually([&] {  // the lease ends, and somebody else has or had the job
    const auto status = client.status(submitted.experiment());
    return std::none_of(status.running().begin(), status.running().end(),
                        [&](const auto& job) { return job.worker() == held.worker(); });
  }));
  slow.signal(SIGCONT);
  EXPECT_EQ(client.wait(submitted.experiment()).state(), "done");
  slow.signal(SIGTERM);
  EXPECT_EQ(slow.wait(), 0);
  quick.signal(SIGTERM);
  quick.wait();
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
  audit(database, true);
  auto db = Database::open(database, Access::kWrite);
  EXPECT_GE(count(*db, "SELECT count(*) FROM attempt WHERE outcome = 'lost'"), 1);
  EXPECT_EQ(count(*db, "SELECT count(*) FROM job") - count(*db, "SELECT count(*) FROM result"), 0) << held.stage();
}

TEST_F(FaultsTest, AJobThatKillsItsWorkersIsQuarantinedAndTheRestGoesOn) {
  Process server{scheduler(), log};
  ASSERT_TRUE(ready());
  LabClient client{address};
  const auto submitted = client.submit(l4_yaml(2));
  Supervisor one{worker("800ms", {"--poison-seed", "2"}), dir / "one.log"};
  std::vector<std::unique_ptr<Supervisor>> others;
  for (int i = 0; i < 3; ++i) {
    others.push_back(std::make_unique<Supervisor>(worker("800ms", {"--poison-seed", "2"}), dir / "more.log"));
  }
  const auto status = client.wait(submitted.experiment(), std::chrono::seconds(120));
  EXPECT_EQ(status.state(), "failed");
  EXPECT_EQ(status.jobs().quarantined(), 4U) << status.ShortDebugString();
  EXPECT_EQ(status.jobs().succeeded(), 36U);
  EXPECT_THAT(status.failures(), testing::Contains(HasSubstr("workers died running it")));
}

TEST_F(FaultsTest, AFullDiskStopsNothingForGoodAndWritesNothingByHalves) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root to mount a small disk";
  const std::string disk = dir / "disk";
  std::filesystem::create_directory(disk);
  if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=2m") != 0) GTEST_SKIP() << "no mounts here";
  struct Unmount {
    std::string path;
    ~Unmount() { umount2(path.c_str(), MNT_DETACH); }
  } const unmount{disk};
  database = disk + "/lab.db";
  {
    Process server{scheduler(), log};
    ASSERT_TRUE(ready());
    LabClient client{address};
    const auto submitted = client.submit(l4_yaml(1));
    const std::string filler = disk + "/filler";
    {
      std::ofstream out{filler, std::ios::binary};
      const std::string block(4096, 'x');
      while (out.write(block.data(), 4096).flush()) {
      }
    }
    Process first{worker("10ms"), dir / "worker.log"};
    ASSERT_TRUE(eventually([&] {
      v1::SubmitRequest request;
      request.set_design_yaml(l4_yaml(8, "does not fit"));
      v1::SubmitReply reply;
      const auto status = client.call(*client.experiments, &v1::Experiments::Stub::Submit, request, &reply);
      return status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED &&
             status.error_message().find("free some space") != std::string::npos;
    }));
    EXPECT_EQ(client.status(submitted.experiment()).state(), "running") << "reading goes on";
    std::filesystem::remove(filler);
    EXPECT_EQ(client.wait(submitted.experiment()).state(), "done") << "it recovers by itself";
    first.signal(SIGTERM);
    first.wait();
    server.signal(SIGTERM);
    EXPECT_EQ(server.wait(), 0) << text_of(log);
  }
  audit(database, true);
  std::filesystem::remove_all(disk + "/lab.db.d");
  std::ofstream fill{disk + "/filler", std::ios::binary};
  const std::string block(4096, 'x');
  while (fill.write(block.data(), 4096).flush()) {
  }
  const auto [code, said] = outcome({programs.scheduler, "--db", disk + "/new.db", "--listen", address});
  EXPECT_EQ(code, 3) << said;
  EXPECT_THAT(said, HasSubstr("free some disk space"));
}

TEST_F(FaultsTest, ChildrenLeaveWithTheirParent) {
  const std::string script = dir / "parent.sh";
  std::ofstream(script) << programs.scheduler << " --db " << database << " --listen " << address << " --exit-with-parent > "
                        << log << " 2>&1 &\necho $! > " << (dir / "pid") << "\nsleep 60\n";
  Process parent{{"/bin/bash", script}, dir / "parent.log"};
  ASSERT_TRUE(ready());
  const pid_t child = std::stoi(text_of(dir / "pid"));
  parent.signal(SIGKILL);
  EXPECT_TRUE(eventually([&] {
    return ::kill(child, 0) != 0 || text_of("/proc/" + std::to_string(child) + "/stat").find(") Z") != std::string::npos;
  }));
}

}  // namespace
}  // namespace regolab::test
