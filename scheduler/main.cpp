/// regolab-scheduler: experiments in, stages out to workers, results kept.
/// Exit codes: 0 stopped on request; 1 internal; 2 usage or bad address; 3 the database cannot be used (in use, newer, not
/// ours, disk full); 4 the address cannot be listened on.
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include "scheduler/rpc/server.h"

namespace {

using regolab::Code;

int exit_code(const regolab::Error& error) {
  switch (error.code) {
    case Code::kInvalidArgument: return 2;
    case Code::kAlreadyExists: return 4;
    case Code::kFailedPrecondition:
    case Code::kResourceExhausted:
    case Code::kDataLoss:
    case Code::kUnavailable: return 3;
    default: return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "regolab-scheduler --db lab.db --listen 127.0.0.1:50551\n"
      "Takes experiments, gives their stages to workers, keeps the results."};
  std::string database, listen = "127.0.0.1:50551", ttl = "15s";
  bool exit_with_parent = false;
  regolab::QueuePolicy policy;
  app.add_option("--db", database, "database file, created if missing")->required();
  app.add_option("--listen", listen, "host:port (port 0: any free one) or unix:/path")->capture_default_str();
  app.add_option("--lease-ttl", policy.lease_ttl, "how long a silent worker keeps its job, e.g. 15s or 500ms")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, int>{{"ms", 1}, {"s", 1000}, {"min", 60000}},
                                        CLI::AsNumberWithUnit::UNIT_REQUIRED))
      ->check(CLI::Range(100, 3600000))
      ->default_str(ttl);
  app.add_option("--quarantine-after", policy.max_deaths, "workers lost in a row at the same step of a job")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--exit-with-parent", exit_with_parent, "stop when the starting process ends");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  spdlog::set_default_logger(spdlog::stderr_logger_mt("scheduler"));
  if (exit_with_parent) {
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) return 0;  // it died before we asked
  }
  sigset_t stop;
  sigemptyset(&stop);
  sigaddset(&stop, SIGTERM);
  sigaddset(&stop, SIGINT);
  pthread_sigmask(SIG_BLOCK, &stop, nullptr);  // before any thread is started

  const auto server = regolab::Server::start({database, listen, policy, [](const regolab::Error& error) {
                                                spdlog::critical("{}; stopping", error.text);
                                                spdlog::shutdown();
                                                _exit(1);  // nothing in memory may be trusted or written any more
                                              }});
  if (!server.ok()) {
    std::fprintf(stderr, "regolab-scheduler: %s\n", server.error().text.c_str());
    return exit_code(server.error());
  }
  std::printf("listening on %s\n", (*server)->address().c_str());
  std::fflush(stdout);
  int signal = 0;
  sigwait(&stop, &signal);
  spdlog::info("stopping");
  return 0;
}
