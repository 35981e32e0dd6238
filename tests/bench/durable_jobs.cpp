/// How many jobs a second go from ready to durably committed (synchronous=FULL) when the stages themselves take no time:
/// desk and store alone, `workers` virtual workers, no network. Prints one line. Not a test: nothing depends on the time.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>

#include "scheduler/rpc/desk.h"
#include "support/temp_dir.h"
#include "support/wishes.h"

namespace {

using namespace regolab;

struct Load {
  Desk& desk;
  std::atomic<int> left;
  std::promise<void> done;

  /// A worker: reports what it has and takes the next, as fast as answers come.
  void exchange(std::string worker, std::uint64_t seq, std::optional<OrderStart> job) {
    WorkerReport report{worker, seq, false, WorkerIdle{}};
    if (job) {
      auto result = std::make_shared<StageResult>();
      result->measurements = {{"bulk_density", 1500, "kg/m3", {}, "made up"}, {"void_ratio", 0.9, "1", {}, "made up"}};
      report.slot = WorkerFinished{job->job, job->token, std::move(result), "", 0.1, 100};
    }
    desk.post(
        Desk::Need::kWrite,
        [this, report](Desk::Turn& turn) -> Desk::Answer {
          const auto order = turn.queue.exchange(report, turn.now, turn.effects);
          return [this, report, order] {
            if (std::holds_alternative<WorkerFinished>(report.slot) && --left == 0) done.set_value();
            const auto* start = order ? std::get_if<OrderStart>(&*order) : nullptr;
            if (start) exchange(report.worker, report.seq + 1, *start);
          };
        },
        [](const Error& error) { std::fprintf(stderr, "%s\n", error.text.c_str()), std::exit(1); });
  }
};

}  // namespace

int main(int argc, char** argv) {
  const int jobs = argc > 1 ? std::atoi(argv[1]) : 5000;
  const int workers = argc > 2 ? std::atoi(argv[2]) : 64;
  const test::TempDir dir;
  auto store = Store::open(dir / "bench.db");
  auto desk = Desk::open(std::move(*store),
                         {.policy = {},
                          .on_fatal = [](const Error& e) { std::fprintf(stderr, "%s\n", e.text.c_str()), std::exit(1); },
                          .on_health = [](bool) {}});
  (*desk)->start();
  std::vector<Wish> wishes;
  for (int i = 1; i <= jobs; ++i)
    wishes.push_back(test::wish(i, test::stage(StageKind::kSettle, static_cast<std::uint64_t>(i))));
  const auto seconds_of = [](auto&& work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  const double submit_s = seconds_of([&] {
    (void)(*desk)
        ->ask(Desk::Need::kWrite,
              [&](Desk::Turn& turn) -> Result<void> {
                ExperimentRecord record;
                record.id = turn.queue.submit(wishes, turn.now, turn.effects);
                record.label = record.name = record.request_id = record.digest = "bench";
                turn.rows = turn.begin();
                if (turn.rows.ok()) turn.rows = turn.store.add_experiment(record);
                return turn.rows;
              })
        .ok();
  });
  Load load{**desk, jobs, {}};
  const double run_s = seconds_of([&] {
    for (int i = 0; i < workers; ++i) load.exchange("worker-" + std::to_string(i), 1, std::nullopt);
    load.done.get_future().wait();
  });
  std::printf("durable jobs: %d jobs, %d workers, submit %.2f s, %.0f jobs/s (lease and result committed)\n", jobs, workers,
              submit_s, jobs / run_s);
}
