#include "scheduler/rpc/status_view.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <set>

#include "scheduler/rpc/persist.h"

namespace regolab {
namespace {

constexpr int kMostFailures = 50;
constexpr Millis kIdleWorkersSpeak = 20'000;

void count(const JobQueue::Job& job, const JobLink& link, v1::JobCounts& counts) {
  switch (job.status.state) {
    case JobState::kBlocked: counts.set_blocked(counts.blocked() + 1); break;
    case JobState::kReady:
    case JobState::kBackoff: counts.set_ready(counts.ready() + 1); break;
    case JobState::kLeased: counts.set_running(counts.running() + 1); break;
    case JobState::kSucceeded: counts.set_succeeded(counts.succeeded() + 1); break;
    case JobState::kFailed: counts.set_failed(counts.failed() + 1); break;
    case JobState::kSkipped: counts.set_skipped(counts.skipped() + 1); break;
    case JobState::kCancelled: counts.set_cancelled(counts.cancelled() + 1); break;
    case JobState::kQuarantined: counts.set_quarantined(counts.quarantined() + 1); break;
  }
  if (job.status.state != JobState::kSucceeded) return;
  if (link.reused) counts.set_reused(counts.reused() + 1);
  if (job.status.end != StageEnd::kCompleted) counts.set_unphysical(counts.unphysical() + 1);
}

void add_running(const JobQueue::Job& job, const JobLink& link, v1::ExperimentStatus& out) {
  v1::RunningJob& running = *out.add_running();
  running.set_worker(job.status.worker);
  running.set_job(static_cast<std::uint64_t>(link.job));
  running.set_point(link.point);
  running.set_seed(link.seed);
  running.set_stage(stage_text(job.identity.spec));
  running.set_phase(job.progress.phase);
  running.set_fraction(job.progress.fraction);
  running.set_sphere_steps_per_s(job.progress.sphere_steps_per_s);
}

void add_failure(const JobQueue::Job& job, const JobLink& link, v1::ExperimentStatus& out) {
  const JobState state = job.status.state;
  const bool unphysical = state == JobState::kSucceeded && job.status.end != StageEnd::kCompleted;
  if (!unphysical && state != JobState::kFailed && state != JobState::kQuarantined) return;
  if (out.failures_size() >= kMostFailures) return;
  const std::string_view what = unphysical ? name_of(job.status.end.value_or(StageEnd::kUnstable)) : name_of(state);
  out.add_failures("point " + std::to_string(link.point) + " seed " + std::to_string(link.seed) + " " +
                   stage_text(job.identity.spec) + ": " + std::string(what) + " (" + job.status.detail + ")");
}

/// Work left over workers; nothing is known before each kind of stage left has been measured once.
double remaining_s(const JobQueue::Experiment& experiment, const Desk::Turn& turn, std::size_t workers) {
  double work = 0, longest = 0;
  std::set<JobId> seen;  // points may share a stage
  for (const std::size_t i : experiment.links) {
    const JobId id = turn.queue.links()[i].job;
    const JobQueue::Job& job = *turn.queue.find(id);
    if (is_final(job.status.state) || !seen.insert(id).second) continue;
    const auto expected = turn.book.expected_s(job.identity.spec);
    if (!expected) return -1;
    const double left = *expected * (1 - job.progress.fraction);
    work += left;
    longest = std::max(longest, left);
  }
  if (work > 0 && workers == 0) return -1;
  return std::max(longest, work / static_cast<double>(std::max<std::size_t>(workers, 1)));
}

}  // namespace

v1::ExperimentStatus status_of(ExperimentId id, const Desk::Turn& turn) {
  v1::ExperimentStatus out;
  const ExperimentRecord* record = turn.book.find(id);
  const JobQueue::Experiment* experiment = turn.queue.find(id);
  if (!record || !experiment) return out;
  out.set_experiment(record->label);
  out.set_name(record->name);
  out.set_state(std::string(name_of(experiment->state)));
  const bool cancelled = experiment->state == ExperimentState::kCancelled;
  std::set<JobId> shown;
  for (const std::size_t i : experiment->links) {
    const JobLink& link = turn.queue.links()[i];
    const JobQueue::Job& job = *turn.queue.find(link.job);
    if (cancelled && !is_final(job.status.state)) {  // goes on for others, not for this one
      out.mutable_jobs()->set_cancelled(out.jobs().cancelled() + 1);
      continue;
    }
    count(job, link, *out.mutable_jobs());
    if (job.status.state == JobState::kLeased && shown.insert(link.job).second) add_running(job, link, out);
    add_failure(job, link, out);
  }
  const std::size_t workers = turn.queue.workers(turn.now, kIdleWorkersSpeak);
  out.set_workers(static_cast<std::uint32_t>(workers));
  out.set_created_unix_ms(record->created_ms);
  out.set_elapsed_s(static_cast<double>(record->ended_ms.value_or(turn.unix_ms) - record->created_ms) / 1000);
  out.set_remaining_s(experiment->state == ExperimentState::kRunning ? remaining_s(*experiment, turn, workers) : 0);
  (void)google::protobuf::util::JsonStringToMessage(record->summary, out.mutable_summary());  // our own text, read back
  return out;
}

}  // namespace regolab
