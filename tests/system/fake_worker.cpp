/// regolab-worker's `serve` with made-up stages: the same flags, and some to misbehave.
#include <CLI/CLI.hpp>

#include "support/fake_stage.h"
#include "worker/rpc/pool_worker.h"

int main(int argc, char** argv) {
  CLI::App app{"a worker for tests"};
  app.require_subcommand(1);
  regolab::ServeOptions options;
  regolab::test::FakeStage stage;
  CLI::App& serve = *app.add_subcommand("serve", "as regolab-worker");
  const std::map<std::string, double> seconds{{"ms", 1e-3}, {"s", 1.0}, {"min", 60.0}};
  serve.add_option("--server", options.server)->required();
  serve.add_option("--threads", options.threads);
  serve.add_option("--checkpoint-every", options.checkpoint_every_s)->transform(CLI::AsNumberWithUnit(seconds));
  serve.add_flag("--exit-with-parent", options.exit_with_parent);
  serve.add_option("--stage-time", stage.duration_s, "how long a stage takes")->transform(CLI::AsNumberWithUnit(seconds));
  serve.add_option("--poison-seed", stage.poison_seed);
  serve.add_option("--broken-seed", stage.broken_seed);
  serve.add_option("--restless-seed", stage.restless_seed);
  CLI11_PARSE(app, argc, argv);
  return regolab::serve_with(options, stage);
}
