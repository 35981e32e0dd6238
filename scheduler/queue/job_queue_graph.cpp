#include <algorithm>
#include <utility>

#include "scheduler/queue/job_queue.h"

namespace regolab {

JobQueue::Job& JobQueue::add_job(const Wish& wish) {
  const JobId id{next_job_++};
  Job& job = jobs_[static_cast<std::uint64_t>(id)];
  job.identity = {.id = id, .key = wish.key, .spec = wish.spec};
  by_key_[wish.key] = id;
  if (!wish.parent_key.empty()) {
    job.identity.parent = by_key_.at(wish.parent_key);  // REQUIRES: settle stages come first
    this->job(job.identity.parent).children.push_back(id);
  }
  return job;
}

JobQueue::Place JobQueue::place_of(const Job& job) const {
  if (job.identity.parent == JobId{}) return {JobState::kReady, ""};
  const JobStatus& parent = find(job.identity.parent)->status;
  switch (parent.state) {
    case JobState::kSucceeded:
      if (parent.end == StageEnd::kCompleted) return {JobState::kReady, ""};
      return {JobState::kSkipped, "no bed to start from (settling ended as " +
                                      std::string(name_of(parent.end.value_or(StageEnd::kUnstable))) +
                                      (parent.detail.empty() ? "" : ": " + parent.detail) + ")"};
    case JobState::kFailed:
    case JobState::kQuarantined:
    case JobState::kSkipped:
      return {JobState::kSkipped, "no bed to start from (settling " + std::string(name_of(parent.state)) +
                                      (parent.detail.empty() ? "" : ": " + parent.detail) + ")"};
    default: return {JobState::kBlocked, ""};
  }
}

void JobQueue::revive(Job& job, Effects& effects) {
  Place place = place_of(job);
  job.status.attempts = job.status.deaths = job.status.deaths_anywhere = 0;
  if (place.state == job.status.state && place.detail == job.status.detail) return;
  job.status.detail = std::move(place.detail);
  move(job, place.state, effects);
}

ExperimentId JobQueue::submit(const std::vector<Wish>& wishes, Millis, Effects& effects) {
  const ExperimentId id{next_experiment_++};
  Experiment& experiment = experiments_[id];
  emit(effects, ExperimentChanged{id, ExperimentState::kRunning});
  for (const Wish& wish : wishes) {
    Job* job = nullptr;
    if (const auto known = by_key_.find(wish.key); known != by_key_.end()) {
      job = &this->job(known->second);
      const JobState state = job->status.state;
      if (state == JobState::kCancelled || state == JobState::kSkipped) revive(*job, effects);
    } else {
      job = &add_job(wish);
      Place place = place_of(*job);
      job->status.state = place.state;
      job->status.detail = std::move(place.detail);
      index(*job);
      emit(effects, JobAdded{{job->identity, job->status}});
    }
    const JobLink link{id, job->identity.id, wish.point, wish.seed, job->status.state == JobState::kSucceeded};
    job->links.push_back(links_.size());
    experiment.links.push_back(links_.size());
    if (!is_final(job->status.state)) ++experiment.open;
    links_.push_back(link);
    emit(effects, Linked{link});
  }
  note({.experiment = id, .kind = EventKind::kSubmitted}, effects);
  refresh(id, effects);
  return id;
}

bool JobQueue::wanted(const Job& job) const {
  return std::any_of(job.links.begin(), job.links.end(), [&](std::size_t i) {
    return experiments_.at(links_[i].experiment).state != ExperimentState::kCancelled;
  });
}

void JobQueue::end_lease(Job& job, const std::string& outcome, const std::string& detail, Effects& effects) {
  emit(effects, AttemptEnded{job.status.token, outcome, detail});
  if (const auto worker = workers_.find(job.status.worker);
      worker != workers_.end() && worker->second.job == job.identity.id) {
    worker->second.job = JobId{};
  }
}

void JobQueue::cancel(ExperimentId id, Millis, Effects& effects) {
  Experiment& experiment = experiments_.at(id);
  if (experiment.state != ExperimentState::kRunning) return;
  experiment.state = ExperimentState::kCancelled;
  emit(effects, ExperimentChanged{id, ExperimentState::kCancelled});
  note({.experiment = id, .kind = EventKind::kEnded}, effects);
  for (const std::size_t i : experiment.links) {
    Job& job = this->job(links_[i].job);
    if (is_final(job.status.state) || wanted(job)) continue;
    if (job.status.state == JobState::kLeased) {
      end_lease(job, "cancelled", "", effects);
      emit(effects, LeaseRevoked{job.status.worker, job.identity.id});
    }
    job.status.detail = "cancelled";
    move(job, JobState::kCancelled, effects);
  }
}

void JobQueue::retry(ExperimentId id, Millis, Effects& effects) {
  Experiment& experiment = experiments_.at(id);
  if (experiment.state == ExperimentState::kCancelled) {
    experiment.state = ExperimentState::kRunning;
    emit(effects, ExperimentChanged{id, ExperimentState::kRunning});
  }
  for (const std::size_t i : experiment.links) {  // settle stages stand before what needs them
    Job& job = this->job(links_[i].job);
    if (is_final(job.status.state) && job.status.state != JobState::kSucceeded) revive(job, effects);
  }
  refresh(id, effects);
}

void JobQueue::release_children(const Job& parent, Effects& effects) {
  for (const JobId id : parent.children) {
    Job& child = job(id);
    if (child.status.state != JobState::kBlocked) continue;
    Place place = place_of(child);
    if (place.state == JobState::kBlocked) continue;
    child.status.detail = std::move(place.detail);
    move(child, place.state, effects);
  }
}

void JobQueue::bed_lost(const std::string& digest, Millis, Effects& effects) {
  for (auto& [number, settle] : jobs_) {
    if (settle.status.bed != digest || settle.status.state != JobState::kSucceeded) continue;
    const bool needed = std::any_of(settle.children.begin(), settle.children.end(),
                                    [&](JobId id) { return !is_final(job(id).status.state); });
    if (!needed) continue;
    emit(effects, ResultForgotten{settle.identity.id});
    settle.status.bed.clear();
    settle.status.end.reset();
    settle.status.detail = "its bed was missing or damaged, so it runs again";
    move(settle, JobState::kReady, effects);
    for (const JobId id : settle.children) {
      Job& child = job(id);
      if (is_final(child.status.state)) continue;
      if (child.status.state == JobState::kLeased) {
        end_lease(child, "cancelled", "the bed is lost", effects);
        emit(effects, LeaseRevoked{child.status.worker, id});
      }
      move(child, JobState::kBlocked, effects);
    }
  }
}

void JobQueue::checkpoint_lost(const std::string& digest, Effects& effects) {
  for (auto& [number, held] : jobs_) {
    if (held.status.checkpoint != digest) continue;
    held.status.checkpoint.clear();
    emit(effects, JobChanged{held.identity.id, held.status});
  }
}

}  // namespace regolab
