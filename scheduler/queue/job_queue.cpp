#include "scheduler/queue/job_queue.h"

#include <algorithm>
#include <utility>

namespace regolab {
namespace {

constexpr std::string_view kFailureNames[] = {"transient", "permanent", "resource", "preempted"};

bool same_place(std::uint64_t a, std::uint64_t b, std::uint64_t stride) { return (a > b ? a - b : b - a) <= stride; }

}  // namespace

std::optional<Order> JobQueue::exchange(const WorkerReport& report, Millis now, Effects& effects) {
  Worker& worker = workers_[report.worker];
  if (report.seq < worker.seq) return OrderKeep{};  // late on the wire: the worker has said more since
  worker.last_heard = now;
  const bool repeated = report.seq == worker.seq;
  if (repeated && worker.answer) return worker.answer;
  worker.seq = report.seq;
  worker.draining = report.draining;
  worker.answer = take(worker, report, now, effects);
  return worker.answer;
}

std::optional<Order> JobQueue::poll(const std::string& name, Millis now, Effects& effects) {
  const auto found = workers_.find(name);
  if (found == workers_.end()) return OrderKeep{};
  Worker& worker = found->second;
  if (!worker.answer) worker.answer = next_for(name, worker, now, effects);
  return worker.answer;
}

std::optional<Order> JobQueue::take(Worker& worker, const WorkerReport& report, Millis now, Effects& effects) {
  if (const auto* run = std::get_if<WorkerRunning>(&report.slot)) return on_running(report.worker, *run, now, effects);
  if (const auto* done = std::get_if<WorkerFinished>(&report.slot)) {
    bool settled = false;
    Order refusal = on_finished(report.worker, worker, *done, now, effects, settled);
    if (!settled) return refusal;
  }
  return next_for(report.worker, worker, now, effects);
}

JobQueue::Job* JobQueue::leased(JobId id, LeaseToken token, const std::string& worker) {
  const auto found = jobs_.find(static_cast<std::uint64_t>(id));
  if (found == jobs_.end()) return nullptr;
  const JobStatus& status = found->second.status;
  const bool live = status.state == JobState::kLeased && status.token == token && status.worker == worker;
  return live ? &found->second : nullptr;
}

std::optional<Order> JobQueue::next_for(const std::string& name, Worker& worker, Millis now, Effects& effects) {
  if (worker.job != JobId{}) {  // it says it runs nothing, so our order never reached it: give it again
    Job& job = this->job(worker.job);
    job.heard = true;
    extend(job, now + policy_.lease_ttl);
    return start_order(job);
  }
  if (worker.draining) return OrderLeave{};
  if (ready_.empty()) return std::nullopt;
  Job& job = this->job(*ready_.begin());
  last_token_ = LeaseToken{static_cast<std::uint64_t>(last_token_) + 1};
  job.status.token = last_token_;
  job.status.worker = name;
  job.status.detail.clear();
  job.heard = true;
  job.stride = 0;
  worker.job = job.identity.id;
  emit(effects, AttemptStarted{job.identity.id, last_token_, name});
  move(job, JobState::kLeased, effects, now + policy_.lease_ttl);
  return start_order(job);
}

Order JobQueue::start_order(const Job& job) const {
  OrderStart start{.job = job.identity.id,
                   .token = job.status.token,
                   .spec = job.identity.spec,
                   .bed = {},
                   .checkpoint = job.status.checkpoint};
  if (job.identity.parent != JobId{}) start.bed = find(job.identity.parent)->status.bed;
  return start;
}

std::optional<Order> JobQueue::on_running(const std::string& name, const WorkerRunning& run, Millis now, Effects& effects) {
  Job* job = leased(run.job, run.token, name);
  if (!job) return OrderDrop{"the lease has ended (expired or cancelled)"};
  job->heard = true;
  if (run.progress.steps > job->progress.steps) job->stride = run.progress.steps - job->progress.steps;
  job->progress = run.progress;
  extend(*job, now + policy_.lease_ttl);
  if (!run.checkpoint.empty() && run.checkpoint != job->status.checkpoint) {
    job->status.checkpoint = run.checkpoint;
    job->status.deaths = 0;  // it gets on: not a job that kills its workers at one place
    emit(effects, JobChanged{job->identity.id, job->status});
  }
  return std::nullopt;
}

Order JobQueue::on_finished(const std::string& name, Worker& worker, const WorkerFinished& done, Millis now,
                            Effects& effects, bool& settled) {
  Job* job = leased(done.job, done.token, name);
  if (!job) {
    const Job* known = find(done.job);  // the answer to an accepted report was lost in a restart
    settled = known && known->status.state == JobState::kSucceeded && known->status.token == done.token;
    return OrderDrop{"the lease has ended (expired or cancelled), the report is refused"};
  }
  settled = true;
  worker.job = JobId{};
  job->status.deaths = job->status.deaths_anywhere = 0;
  if (const auto* failure = std::get_if<JobFailure>(&done.outcome)) {
    end_lease(*job, std::string(kFailureNames[static_cast<int>(failure->kind)]), failure->text, effects);
    on_failure(*job, *failure, now, effects);
    return OrderKeep{};
  }
  const auto& result = std::get<std::shared_ptr<const StageResult>>(done.outcome);
  emit(effects, ResultAccepted{job->identity.id, done.token, result, done.wall_s, done.steps});
  end_lease(*job, "result", result->reason, effects);
  job->status.end = result->end;
  job->status.detail = result->reason;
  job->status.bed = done.bed;
  job->status.checkpoint.clear();
  job->status.wall_s = done.wall_s;
  job->status.steps = done.steps;
  move(*job, JobState::kSucceeded, effects, 0, result);
  release_children(*job, effects);
  return OrderKeep{};
}

void JobQueue::on_failure(Job& job, const JobFailure& failure, Millis now, Effects& effects) {
  job.status.detail = failure.text;
  if (failure.kind == FailureClass::kPreempted) return move(job, JobState::kReady, effects);
  ++job.status.attempts;
  if (failure.kind == FailureClass::kPermanent || job.status.attempts >= policy_.max_attempts) {
    move(job, JobState::kFailed, effects);
    return release_children(job, effects);
  }
  move(job, JobState::kBackoff, effects, now + backoff(job, failure.kind));
  for (const std::size_t i : job.links) {
    const JobLink link = links_[i];
    if (experiments_.at(link.experiment).state == ExperimentState::kCancelled) continue;
    note({.experiment = link.experiment,
          .kind = EventKind::kRetry,
          .job = job.identity.id,
          .point = link.point,
          .seed = link.seed,
          .state = JobState::kBackoff,
          .detail = failure.text,
          .result = nullptr},
         effects);
  }
}

Millis JobQueue::backoff(const Job& job, FailureClass kind) const {
  Millis pause = policy_.first_backoff * (kind == FailureClass::kResource ? 4 : 1);
  for (int i = 1; i < job.status.attempts && pause < policy_.longest_backoff; ++i) pause *= 2;
  pause = std::min(pause, policy_.longest_backoff);
  const auto spread =
      (static_cast<std::uint64_t>(job.identity.id) * 7919U + static_cast<std::uint64_t>(job.status.attempts)) % 256;
  return pause + pause * static_cast<Millis>(spread) / 1024;  // up to a quarter more, so that failures do not march in step
}

void JobQueue::on_lost_worker(Job& job, Millis, Effects& effects) {
  end_lease(job, "lost", job.heard ? "" : "not heard since the scheduler started", effects);
  if (job.heard) {  // else nobody knows whether the worker or only the scheduler was away
    const bool again = job.status.deaths > 0 && same_place(job.progress.steps, job.status.death_steps, 2 * job.stride);
    // Stages are pure functions: one that kills its worker does so at the same step. Other deaths are the machine's.
    job.status.deaths = again ? job.status.deaths + 1 : 1;
    ++job.status.deaths_anywhere;
    job.status.death_steps = job.progress.steps;
  }
  // Where nothing was heard of the run, the same place means little: twice the patience.
  const int patience = job.status.death_steps > 0 ? policy_.max_deaths : 2 * policy_.max_deaths;
  if (job.status.deaths >= patience || job.status.deaths_anywhere >= policy_.max_deaths_anywhere) {
    job.status.detail = std::to_string(job.status.deaths_anywhere) + " workers died running it (the last at step " +
                        std::to_string(job.status.death_steps) + "), look at the workers' logs, then retry";
    move(job, JobState::kQuarantined, effects);
    return release_children(job, effects);
  }
  job.status.detail = "its worker was lost";
  move(job, JobState::kReady, effects);
}

void JobQueue::tick(Millis now, Effects& effects) {
  while (!deadlines_.empty() && deadlines_.begin()->first <= now) {
    Job& job = this->job(deadlines_.begin()->second);
    if (job.status.state == JobState::kLeased)
      on_lost_worker(job, now, effects);
    else
      move(job, JobState::kReady, effects);
  }
  std::erase_if(workers_, [&](const auto& entry) {
    return entry.second.job == JobId{} && entry.second.last_heard + 10 * policy_.lease_ttl < now;
  });
}

void JobQueue::forget_idle(const std::string& name) {
  const auto found = workers_.find(name);
  if (found != workers_.end() && found->second.job == JobId{}) workers_.erase(found);
}

}  // namespace regolab
