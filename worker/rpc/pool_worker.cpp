#include "worker/rpc/pool_worker.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

#include "worker/rpc/session.h"

namespace regolab {
namespace {

/// Host, process and start time: no two processes share it.
std::string unique_name() {
  char host[64] = {};
  gethostname(host, sizeof host - 1);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::string(host) + "-" + std::to_string(getpid()) + "-" +
         std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(now).count() % 100'000'000);
}

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGINT);
  return set;
}

}  // namespace

int serve_with(const ServeOptions& options, StageFunction run) {
  spdlog::set_default_logger(spdlog::stderr_logger_mt("worker"));
  if (options.exit_with_parent) {
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) return 0;  // it died before we asked
  }
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);  // inherited by every thread below
  Session session({.server = options.server,
                   .name = unique_name(),
                   .stage = {.threads = options.threads, .checkpoint_every_s = options.checkpoint_every_s}},
                  std::move(run));
  std::jthread listener([&](const std::stop_token& stop) {
    const timespec tick{0, 200'000'000};
    while (!stop.stop_requested()) {
      if (sigtimedwait(&set, nullptr, &tick) > 0) session.leave();
    }
  });
  return session.run();
}

}  // namespace regolab
