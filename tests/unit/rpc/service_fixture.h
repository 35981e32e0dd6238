/// Server, store and worker sessions in one process, over a real socket.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>

#include "scheduler/rpc/server.h"
#include "support/fake_stage.h"
#include "support/lab_client.h"
#include "support/temp_dir.h"
#include "worker/rpc/session.h"

namespace regolab::test {

struct ServiceTest : testing::Test {
  test::TempDir dir;
  QueuePolicy policy;
  std::unique_ptr<Server> server;
  std::unique_ptr<LabClient> client;

  explicit ServiceTest(Millis lease_ttl = 1000)
      : policy{.lease_ttl = lease_ttl, .first_backoff = 20, .longest_backoff = 100} {
    start();
  }
  void start() {
    auto started = Server::start(
        {dir / "lab.db", "unix:" + (dir / "socket"), policy, [](const Error& error) { FAIL() << error.text; }});
    ASSERT_TRUE(started.ok()) << started.error().text;
    server = std::move(*started);
    client = std::make_unique<LabClient>(server->address());
  }
  void restart() {
    server.reset();
    start();
  }

  /// A worker in a thread of this process; leaves when the object goes.
  struct Worker {
    Worker(const ServiceTest& test, const std::string& name, FakeStage stage)
        : session(
              {.server = "unix:" + (test.dir / "socket"), .name = name, .stage = {.threads = 1, .checkpoint_every_s = 0.05}},
              stage),
          thread([this] { session.run(); }) {}
    ~Worker() { session.leave(); }
    Session session;
    std::jthread thread;
  };
};

}  // namespace regolab::test
