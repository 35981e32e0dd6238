/// kill -9 of any program at any moment: the study ends with the bits of an undisturbed run, nothing lost, nothing doubled.
#include <algorithm>
#include <random>

#include "audit.h"
#include "processes.h"
#include "support/lab_client.h"
#include "support/temp_dir.h"

namespace regolab::test {
namespace {

constexpr int kKills = 30;
constexpr int kWorkers = 3;
constexpr std::chrono::minutes kLimit{20};

struct Lab {
  explicit Lab(const TempDir& dir, const std::string& name)
      : database(dir / (name + ".db")),
        address("unix:" + (dir / (name + ".socket"))),
        scheduler({programs.scheduler, "--db", database, "--listen", address, "--lease-ttl", "1s"}, dir / (name + ".log")),
        client(address) {
    Command command{programs.worker, "serve", "--server", address, "--checkpoint-every", "200ms"};
    if (const char* more = std::getenv("REGOLAB_TEST_WORKER_FLAGS")) command.insert(command.end(), {"--stage-time", more});
    for (int i = 0; i < kWorkers; ++i) {
      workers.push_back(std::make_unique<Supervisor>(command, dir / (name + ".worker" + std::to_string(i) + ".log")));
    }
  }
  void stop() {
    for (auto& worker : workers) EXPECT_EQ(worker->stop(), 0) << "a worker leaves in good order";
    EXPECT_EQ(scheduler.stop(), 0);
  }
  Programs programs;
  std::string database, address;
  Supervisor scheduler;
  std::vector<std::unique_ptr<Supervisor>> workers;
  LabClient client;
};

v1::SubmitReply submit_patiently(LabClient& client, const std::string& yaml) {
  v1::SubmitRequest request;
  request.set_design_yaml(yaml);
  request.set_request_id("the one study");
  v1::SubmitReply reply;
  EXPECT_TRUE(
      eventually([&] { return client.call(*client.experiments, &v1::Experiments::Stub::Submit, request, &reply).ok(); }));
  return reply;
}

TEST(Kill, ThirtyRandomKillsChangeNoBit) {
  const TempDir dir;
  const std::string yaml = l4_yaml(1);
  std::map<std::string, std::string> expected;
  std::chrono::steady_clock::duration undisturbed{};
  {
    Lab calm{dir, "calm"};
    const auto submitted = submit_patiently(calm.client, yaml);
    const auto began = std::chrono::steady_clock::now();
    const auto status = calm.client.wait(submitted.experiment(), kLimit);
    ASSERT_EQ(status.state(), "done") << status.ShortDebugString();
    undisturbed = std::chrono::steady_clock::now() - began;
    expected = calm.client.results_by_key(submitted.experiment());
    calm.stop();
    audit(calm.database, true);
  }
  ASSERT_EQ(expected.size(), 20U);

  const std::uint64_t seed = std::random_device{}();
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937_64 random{seed};
  Lab lab{dir, "stormy"};
  const auto submitted = submit_patiently(lab.client, yaml);
  const double longest_pause_s = std::clamp(std::chrono::duration<double>(undisturbed).count() / 12, 0.2, 2.0);
  int kills = 0;
  for (; kills < kKills; ++kills) {
    const double pause = std::uniform_real_distribution<>{0.02, longest_pause_s}(random);
    std::this_thread::sleep_for(std::chrono::duration<double>(pause));
    const std::size_t victim = random() % (kWorkers + 1);
    if (victim == kWorkers)
      lab.scheduler.kill();
    else
      lab.workers[victim]->kill();
    if (kills + 1 < kKills && lab.client.status(submitted.experiment()).state() == "done") break;
  }
  EXPECT_EQ(kills, kKills) << "the study was over too soon: make it longer";
  const auto status = lab.client.wait(submitted.experiment(), kLimit);
  EXPECT_EQ(status.state(), "done") << status.ShortDebugString() << "\nseed " << seed;
  EXPECT_EQ(status.jobs().succeeded(), 20U);
  EXPECT_TRUE(lab.client.results_by_key(submitted.experiment()) == expected)
      << "results differ from the undisturbed run, seed " << seed;
  EXPECT_GT(lab.scheduler.starts, 1);
  lab.stop();
  audit(lab.database, true);
}

}  // namespace
}  // namespace regolab::test
