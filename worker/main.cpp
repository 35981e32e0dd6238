/// The worker program: `run` does one job on this machine, `serve` works for a scheduler, `bench` times a step.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <string>
#include <thread>

#include "vocab/profile.h"
#include "worker/bench/report.h"
#include "worker/output/run_command.h"
#include "worker/output/signal_stop.h"
#include "worker/rpc/serve.h"
#include "worker/stage/run_stage.h"

namespace {

using namespace regolab;

const std::map<std::string, double> kSeconds{{"ms", 1e-3}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}};

void add_common(CLI::App& verb, int& threads, double& checkpoint_every_s) {
  verb.add_option("--threads", threads, "inside one stage; pays for large beds on idle cores; does not change the results")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  verb.add_option("--checkpoint-every", checkpoint_every_s, "wall time between checkpoints: 60s, 5min, ...")
      ->transform(CLI::AsNumberWithUnit(kSeconds))
      ->check(CLI::PositiveNumber)
      ->default_str("60s");
}

int run(const RunCommand& command) {
  const SignalStop signals;
  const RunDoors doors{.run_stage = run_stage, .breach_of = breach_of, .view_bed = view_bed, .stop = signals.token()};
  return run_command(command, doors, std::cout, std::cerr);
}

/// A line that is rewritten, on a terminal only.
bench::OnProgress measuring_line(bool terminal) {
  if (!terminal) return {};
  return [shown = -1](double fraction) mutable {
    const int percent = static_cast<int>(100 * fraction);
    if (percent == shown) return;
    shown = percent;
    std::cerr << "\rmeasuring " << percent << " %" << (percent == 100 ? "\r               \r" : "") << std::flush;
  };
}

int bench_machine(const bench::Study& study) {
  const auto figure = bench::measure_machine({}, measuring_line(::isatty(STDERR_FILENO) == 1));
  if (!figure) {
    std::cerr << "regolab-worker: no bed to time (its parents found no room) please report this\n";
    return kExitInternal;
  }
  std::cout << bench::report(*figure, study) << std::flush;
  return kExitDone;
}

void add_study(CLI::App& verb, bench::Study& study) {
  study.workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  verb.add_option("--profile", study.profile, "accuracy of the study to estimate: quick, standard or article")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(kProfileNames), std::end(kProfileNames))))
      ->capture_default_str();
  verb.add_option("--rows", study.rows, "materials of the study")->check(CLI::Range(1, 4096))->capture_default_str();
  verb.add_option("--seeds", study.seeds, "seeds per material")->check(CLI::Range(1, 10000))->capture_default_str();
  verb.add_option("--workers", study.workers, "worker processes, one core each")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

int parse_and_run(int argc, char** argv) {
  CLI::App app{"Regolab's DEM worker: lunar soil as rigid clusters of spheres"};
  app.set_version_flag("--version", "regolab-worker " + program_version());
  app.require_subcommand(1);
  app.footer("Example: regolab-worker run job.yaml --out results/job-1");

  RunCommand command{.terminal = ::isatty(STDERR_FILENO) == 1};
  CLI::App& run_verb = *app.add_subcommand("run", "settle, measure and test one material, without a scheduler");
  run_verb.add_option("job", command.job_file, "JOB.yaml")->required();
  run_verb
      .add_option("--out", command.directory, "folder for the results; an interrupted run goes on from what it finds there")
      ->required();
  add_common(run_verb, command.threads, command.checkpoint_every_s);
  run_verb.add_flag("--quiet", command.quiet, "no progress");

  ServeOptions serving;
  CLI::App& serve_verb = *app.add_subcommand("serve", "ask a scheduler for stages until told to leave");
  serve_verb.add_option("--server", serving.server, "unix:/path or host:port")->required();
  add_common(serve_verb, serving.threads, serving.checkpoint_every_s);
  serve_verb.add_flag("--exit-with-parent", serving.exit_with_parent, "leave when the starting process is gone");

  bench::Study study;
  CLI::App& bench_verb = *app.add_subcommand("bench", "what a step costs on this machine, and how long a study would take");
  add_study(bench_verb, study);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitDone : kExitUsage;  // --help and --version count as done
  }
  if (bench_verb.parsed()) return bench_machine(study);
  return run_verb.parsed() ? run(command) : serve(serving);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const std::exception& problem) {  // what libraries throw and nobody expected, e.g. no memory left
    std::cerr << "regolab-worker: stopped (" << problem.what() << ") please report this with the job file\n";
    return kExitInternal;
  }
}
