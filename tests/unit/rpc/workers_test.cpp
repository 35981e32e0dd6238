/// Workers that outlive their scheduler, leave, or are told to stop.
#include <atomic>
#include <filesystem>

#include "unit/rpc/service_fixture.h"

namespace regolab {
namespace {

using ServiceTest = test::ServiceTest;
using test::FakeStage;
using test::l4_yaml;

TEST_F(ServiceTest, AWorkerOutlivesItsSchedulerAndDeliversThen) {
  const auto submitted = client->submit(l4_yaml(1));
  const Worker a{*this, "a", {.duration_s = 0.15}}, b{*this, "b", {.duration_s = 0.15}};
  while (client->status(submitted.experiment()).running_size() == 0) std::this_thread::yield();
  server.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // the stages end while nobody listens
  start();
  const auto status = client->wait(submitted.experiment());
  EXPECT_EQ(status.state(), "done");
}

TEST_F(ServiceTest, ALeavingWorkerHandsItsCheckpointToTheNext) {
  const auto undisturbed = client->submit(l4_yaml(1));
  {
    const Worker a{*this, "a", {.duration_s = 0.02}};
    client->wait(undisturbed.experiment());
  }
  const auto expected = client->results_by_key(undisturbed.experiment());
  server.reset();
  std::filesystem::remove_all(dir / "lab.db.d");
  for (const char* name : {"lab.db", "lab.db-wal", "lab.db-shm"}) std::filesystem::remove(dir / name);
  start();
  const auto disturbed = client->submit(l4_yaml(1));
  std::atomic<int> resumed = 0;
  const FakeStage fake{.duration_s = 0.15};
  for (int i = 0; client->status(disturbed.experiment()).state() == "running"; ++i) {
    Session session(
        {.server = server->address(), .name = "w" + std::to_string(i), .stage = {.threads = 1, .checkpoint_every_s = 0.05}},
        [&](const StageSpec& spec, const std::string& bed, const std::string& checkpoint, const StageHooks& hooks) {
          if (!checkpoint.empty()) ++resumed;
          return fake(spec, bed, checkpoint, hooks);
        });
    std::jthread thread([&] { session.run(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(220));
    session.leave();
  }
  EXPECT_GT(resumed, 2);
  EXPECT_EQ(client->results_by_key(disturbed.experiment()), expected) << "bit-equal to the undisturbed run";
}

TEST_F(ServiceTest, CancelStopsTheRunningStageAtOnce) {
  const auto submitted = client->submit(l4_yaml(1));
  const Worker a{*this, "a", {.duration_s = 30}};
  while (client->status(submitted.experiment()).running_size() == 0) std::this_thread::yield();
  v1::CancelRequest request;
  request.set_experiment(submitted.experiment());
  v1::ExperimentStatus status;
  grpc::ClientContext context;
  ASSERT_TRUE(client->experiments->Cancel(&context, request, &status).ok());
  EXPECT_EQ(status.state(), "cancelled");
  EXPECT_EQ(status.jobs().cancelled(), 20U);
  const auto table = client->table(submitted.experiment());
  EXPECT_EQ(table.rows(0).missing().at("repose_angle"), "cancelled");
  const auto next = client->submit(l4_yaml(1, "next", "numerics: {step_fraction: 0.1}\n"));
  const auto began = std::chrono::steady_clock::now();
  while (client->status(next.experiment()).running_size() == 0) std::this_thread::yield();
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10)) << "the worker was not let go";
  const auto back = client->submit(l4_yaml(1));  // the cancelled study again: goes on
  EXPECT_TRUE(back.already_known());
  EXPECT_EQ(client->status(submitted.experiment()).state(), "running");
}

}  // namespace
}  // namespace regolab
