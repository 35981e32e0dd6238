#include <algorithm>
#include <utility>

#include "scheduler/queue/job_queue.h"

namespace regolab {

void JobQueue::index(const Job& job) {
  if (job.status.state == JobState::kReady) ready_.insert(job.identity.id);
  if (job.status.state == JobState::kLeased || job.status.state == JobState::kBackoff) {
    deadlines_.emplace(job.deadline, job.identity.id);
  }
}

void JobQueue::unindex(const Job& job) {
  ready_.erase(job.identity.id);
  deadlines_.erase({job.deadline, job.identity.id});
}

void JobQueue::extend(Job& job, Millis deadline) {
  unindex(job);
  job.deadline = deadline;
  index(job);
}

void JobQueue::move(Job& job, JobState to, Effects& effects, Millis deadline, std::shared_ptr<const StageResult> result) {
  const JobState from = job.status.state;
  unindex(job);
  job.status.state = to;
  job.deadline = deadline;
  if (to != JobState::kLeased) job.progress = {};
  index(job);
  emit(effects, JobChanged{job.identity.id, job.status});
  tell_experiments(job, from, result, effects);
}

void JobQueue::tell_experiments(const Job& job, JobState from, const std::shared_ptr<const StageResult>& result,
                                Effects& effects) {
  const JobState to = job.status.state;
  std::set<ExperimentId> touched;
  for (const std::size_t i : job.links) {
    const JobLink& link = links_[i];
    Experiment& experiment = experiments_.at(link.experiment);
    if (is_final(from) && !is_final(to)) ++experiment.open;
    if (!is_final(from) && is_final(to)) --experiment.open;
    touched.insert(link.experiment);
    if (experiment.state == ExperimentState::kCancelled || !is_final(to) || from == to) continue;
    note({.experiment = link.experiment,
          .kind = EventKind::kJob,
          .job = job.identity.id,
          .point = link.point,
          .seed = link.seed,
          .state = to,
          .detail = job.status.detail,
          .result = result},
         effects);
  }
  for (const ExperimentId id : touched) refresh(id, effects);
}

void JobQueue::note(EventNoted event, Effects& effects) {
  event.seq = experiments_.at(event.experiment).next_seq++;
  emit(effects, std::move(event));
}

void JobQueue::refresh(ExperimentId id, Effects& effects) {
  Experiment& experiment = experiments_.at(id);
  if (experiment.state == ExperimentState::kCancelled) return;
  ExperimentState state = ExperimentState::kRunning;
  if (experiment.open == 0) {
    const bool failed = std::any_of(experiment.links.begin(), experiment.links.end(), [&](std::size_t i) {
      const JobState s = job(links_[i].job).status.state;
      return s == JobState::kFailed || s == JobState::kQuarantined;
    });
    state = failed ? ExperimentState::kFailed : ExperimentState::kDone;
  }
  if (state == experiment.state) return;
  experiment.state = state;
  emit(effects, ExperimentChanged{id, state});
  if (state != ExperimentState::kRunning) note({.experiment = id, .kind = EventKind::kEnded}, effects);
}

void JobQueue::restore(JobRecord record) {
  const auto id = static_cast<std::uint64_t>(record.identity.id);
  next_job_ = std::max(next_job_, id + 1);
  by_key_[record.identity.key] = record.identity.id;
  if (record.identity.parent != JobId{}) job(record.identity.parent).children.push_back(record.identity.id);
  Job& held = jobs_[id];
  held.identity = std::move(record.identity);
  held.status = std::move(record.status);
}

void JobQueue::restore(ExperimentId id, ExperimentState state, std::uint64_t next_seq) {
  next_experiment_ = std::max(next_experiment_, static_cast<std::uint64_t>(id) + 1);
  Experiment& experiment = experiments_[id];
  experiment.state = state;
  experiment.next_seq = next_seq;
}

void JobQueue::restore(const JobLink& link) {
  Job& linked = job(link.job);
  Experiment& experiment = experiments_.at(link.experiment);
  linked.links.push_back(links_.size());
  experiment.links.push_back(links_.size());
  if (!is_final(linked.status.state)) ++experiment.open;
  links_.push_back(link);
}

void JobQueue::restored(Millis now) {
  for (auto& [id, held] : jobs_) {
    if (held.status.state == JobState::kLeased) {
      held.deadline = now + policy_.lease_ttl;
      workers_[held.status.worker].job = held.identity.id;
      workers_[held.status.worker].last_heard = now - policy_.lease_ttl;  // not heard by this queue
    }
    if (held.status.state == JobState::kBackoff) held.deadline = now + backoff(held, FailureClass::kTransient);
    index(held);
  }
}

const JobQueue::Job* JobQueue::find(JobId id) const {
  const auto found = jobs_.find(static_cast<std::uint64_t>(id));
  return found == jobs_.end() ? nullptr : &found->second;
}

const JobQueue::Job* JobQueue::find_key(const std::string& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? nullptr : find(found->second);
}

const JobQueue::Experiment* JobQueue::find(ExperimentId id) const {
  const auto found = experiments_.find(id);
  return found == experiments_.end() ? nullptr : &found->second;
}

std::size_t JobQueue::workers(Millis now, Millis slack) const {
  return static_cast<std::size_t>(std::count_if(workers_.begin(), workers_.end(), [&](const auto& worker) {
    return worker.second.seq > 0 && worker.second.last_heard + policy_.lease_ttl + slack > now;
  }));
}

}  // namespace regolab
