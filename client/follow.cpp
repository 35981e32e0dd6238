#include "client/follow.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "client/interrupt.h"
#include "client/progress.h"

namespace regolab::client {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kTryAgainEvery = 300ms;

Clock::time_point deadline_of(double timeout_s) {
  if (timeout_s <= 0) return Clock::time_point::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s));
}

}  // namespace

bool has_ended(const pb::ExperimentStatus& status) { return !status.state().empty() && status.state() != "running"; }

Outcome follow(Lab& lab, const std::string& experiment, FollowOptions& options, Console& console,
               pb::ExperimentStatus& last) {
  ProgressLine line(console);
  const auto until = deadline_of(options.timeout_s);
  auto lost_at = Clock::time_point::max();
  while (true) {
    const Outcome ended = lab.watch(experiment, options.from_seq, until, [&](const pb::WatchEvent& event) {
      if (lost_at != Clock::time_point::max()) line.say("connected again");
      lost_at = Clock::time_point::max();
      if (event.has_status()) last = event.status();
      if (!event.progress_only()) {
        options.from_seq = std::max<std::uint64_t>(options.from_seq, event.seq() + 1);
        if (options.verbose && !event.text().empty()) line.say(event.text());
        if (options.on_event) options.on_event(event);
      }
      line.show(last);
    });
    if (ended.ok()) {
      if (auto got = lab.get(experiment, last); !got.ok()) return got;
      if (has_ended(last)) return done();
    } else if (ended.exit == Exit::kTimeout) {
      return failed(Exit::kTimeout,
                    fmt::format("not done after {} s (--timeout) the experiment is kept; follow it again with "
                                "`regolab watch {}`",
                                options.timeout_s, experiment));
    } else if (ended.exit != Exit::kUnreachable || interrupted().stop_requested()) {
      return ended;
    } else if (lost_at == Clock::time_point::max()) {
      lost_at = Clock::now();
      line.say("connection to the scheduler lost; trying again");
    } else if (Clock::now() - lost_at > options.patience) {
      return ended;
    }
    std::this_thread::sleep_for(kTryAgainEvery);
  }
}

Outcome verdict_of(const pb::ExperimentStatus& status) {
  const auto& jobs = status.jobs();
  const unsigned lost = jobs.failed() + jobs.skipped() + jobs.quarantined() + jobs.cancelled();
  if (lost + jobs.unphysical() == 0) return done();
  return failed(Exit::kTrialsFailed,
                fmt::format("{} jobs without numbers ({} failed, {} skipped, {} quarantined, {} cancelled, {} ended "
                            "unphysically) the range analysis says which cells are missing",
                            lost + jobs.unphysical(), jobs.failed(), jobs.skipped(), jobs.quarantined(), jobs.cancelled(),
                            jobs.unphysical()));
}

}  // namespace regolab::client
