/// The store's tables in memory: applies the queue's effects and checks what a transaction would check.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scheduler/queue/job_queue.h"

namespace regolab::test {

struct Tables {
  struct Event {
    EventKind kind;
    JobId job;
    JobState state;
  };
  struct Study {
    ExperimentState state{};
    std::vector<Event> events;  ///< event n has seq n + 1
  };
  struct Attempt {
    JobId job;
    std::string outcome;  ///< empty while it runs
  };

  std::map<JobId, JobRecord> jobs;
  std::vector<JobLink> links;
  std::map<ExperimentId, Study> studies;
  std::map<LeaseToken, Attempt> attempts;
  std::map<JobId, StageResult> results;
  std::vector<std::string> breaches;  ///< of the invariants; empty is well

  void apply(const Effects& effects) {
    for (const Effect& effect : effects) std::visit([this](const auto& e) { take(e); }, effect);
  }

  JobQueue load(const QueuePolicy& policy, LeaseToken last_token, Millis now) const {
    JobQueue queue{policy, last_token};
    for (const auto& [id, record] : jobs) queue.restore(record);
    for (const auto& [id, study] : studies) queue.restore(id, study.state, study.events.size() + 1);
    for (const JobLink& link : links) queue.restore(link);
    queue.restored(now);
    return queue;
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) breaches.push_back(what);
  }
  void take(const JobAdded& e) {
    for (const auto& [id, other] : jobs) expect(other.identity.key != e.record.identity.key, "I1: one job per stage_key");
    expect(jobs.emplace(e.record.identity.id, e.record).second, "a job id is used once");
    check_ready(e.record.identity.id);
  }
  void take(const JobChanged& e) {
    jobs.at(e.job).status = e.status;
    check_ready(e.job);
  }
  void take(const Linked& e) { links.push_back(e.link); }
  void take(const ExperimentChanged& e) { studies[e.experiment].state = e.state; }
  void take(const AttemptStarted& e) {
    expect(attempts.empty() || attempts.rbegin()->first < e.token, "I3: tokens strictly rise");
    for (const auto& [token, attempt] : attempts) {
      expect(attempt.job != e.job || !attempt.outcome.empty(), "I3: one live lease per job");
    }
    attempts[e.token] = {e.job, ""};
  }
  void take(const AttemptEnded& e) {
    expect(attempts.at(e.token).outcome.empty(), "an attempt ends once");
    attempts.at(e.token).outcome = e.outcome;
  }
  void take(const ResultAccepted& e) {
    const JobStatus& status = jobs.at(e.job).status;
    expect(status.state == JobState::kLeased && status.token == e.token, "a result comes under the newest lease");
    expect(results.emplace(e.job, *e.result).second, "I1: one result per stage_key");
  }
  void take(const ResultForgotten& e) { expect(results.erase(e.job) == 1, "only a stored result is forgotten"); }
  void take(const EventNoted& e) {
    Study& study = studies.at(e.experiment);
    study.events.push_back({e.kind, e.job, e.state});
    expect(e.seq == study.events.size(), "I7: events are numbered without gaps");
  }
  void take(const LeaseRevoked&) {}

  void check_ready(JobId id) {
    const JobRecord& job = jobs.at(id);
    if (job.status.state != JobState::kReady && job.status.state != JobState::kLeased) return;
    if (job.identity.parent == JobId{}) return;
    const JobStatus& parent = jobs.at(job.identity.parent).status;
    expect(parent.state == JobState::kSucceeded && parent.end == StageEnd::kCompleted, "I4: ready only on a settled bed");
  }
};

}  // namespace regolab::test
