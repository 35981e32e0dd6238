/// The durable queue's core: a deterministic state machine without clock, thread, socket or database. Every call takes the
/// time and appends to `effects` what the caller must make durable before it lets the answer out.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "scheduler/queue/effects.h"
#include "scheduler/queue/exchange.h"

namespace regolab {

using Millis = std::int64_t;  ///< steady time [ms]

struct QueuePolicy {
  Millis lease_ttl = 15'000;
  int max_attempts = 5;          ///< counted failures, then FAILED
  int max_deaths = 3;            ///< workers lost in a row at the same place, then QUARANTINED; twice that if none was heard
  int max_deaths_anywhere = 40;  ///< the same wherever they were: no job may take workers for ever
  Millis first_backoff = 1'000;  ///< doubles with every failure
  Millis longest_backoff = 60'000;
};

/// One stage an experiment wants. A stage on a bed comes after its settle stage.
struct Wish {
  int point = 0;
  std::uint64_t seed = 0;
  StageSpec spec;
  std::string key;         ///< stage_key(spec)
  std::string parent_key;  ///< stage_key(parent_of(spec)), empty for settle
};

class JobQueue {
 public:
  struct Job {
    JobIdentity identity;
    JobStatus status;
    std::vector<JobId> children;
    std::vector<std::size_t> links;  ///< indices into links()
    Millis deadline = 0;             ///< of the lease, or of the backoff
    bool heard = false;              ///< its worker spoke since this queue started
    std::uint64_t stride = 0;        ///< steps between the last two reports: how well we know where a worker died
    JobProgress progress;
  };
  struct Experiment {
    ExperimentState state = ExperimentState::kRunning;
    std::vector<std::size_t> links;  ///< in the order submitted
    std::size_t open = 0;            ///< links whose job is not final
    std::uint64_t next_seq = 1;
  };

  /// Tokens handed out are greater than `last_token`.
  JobQueue(QueuePolicy policy, LeaseToken last_token) : policy_(policy), last_token_(last_token) {}

  // At start, from the tables: jobs (parents first), then experiments, then links, then once restored().
  void restore(JobRecord record);
  void restore(ExperimentId id, ExperimentState state, std::uint64_t next_seq);
  void restore(const JobLink& link);
  /// Leases go on for one more lifetime, so that workers that outlived the scheduler may report.
  void restored(Millis now);

  ExperimentId submit(const std::vector<Wish>& wishes, Millis now, Effects& effects);
  void cancel(ExperimentId id, Millis now, Effects& effects);
  /// Failed, cancelled, quarantined and skipped jobs are tried again.
  void retry(ExperimentId id, Millis now, Effects& effects);

  /// nullopt: nothing to say yet; the caller may hold the call and poll() later, and must answer OrderKeep in the end.
  std::optional<Order> exchange(const WorkerReport& report, Millis now, Effects& effects);
  std::optional<Order> poll(const std::string& worker, Millis now, Effects& effects);
  /// A worker that runs nothing has closed its call.
  void forget_idle(const std::string& worker);

  /// A bed turned out missing or damaged: its settle stage runs again if anybody needs it.
  void bed_lost(const std::string& digest, Millis now, Effects& effects);
  void checkpoint_lost(const std::string& digest, Effects& effects);

  /// Ends leases and pauses whose time has come.
  void tick(Millis now, Effects& effects);

  const Job* find(JobId id) const;
  const Job* find_key(const std::string& key) const;
  const Experiment* find(ExperimentId id) const;
  const std::map<ExperimentId, Experiment>& experiments() const { return experiments_; }
  const std::unordered_map<std::uint64_t, Job>& jobs() const { return jobs_; }
  const std::vector<JobLink>& links() const { return links_; }
  LeaseToken last_token() const { return last_token_; }
  bool anything_ready() const { return !ready_.empty(); }
  /// Workers heard within one lease lifetime and `slack`.
  std::size_t workers(Millis now, Millis slack) const;
  const QueuePolicy& policy() const { return policy_; }

 private:
  struct Worker {
    std::uint64_t seq = 0;
    std::optional<Order> answer;  ///< to `seq`, once there is one
    JobId job{};                  ///< leased to it
    Millis last_heard = 0;
    bool draining = false;
  };

  Job& job(JobId id) { return jobs_.at(static_cast<std::uint64_t>(id)); }
  // Bookkeeping (job_queue_state.cpp). The one place where a job's state changes: indices, counts and events stay true.
  void move(Job& job, JobState to, Effects& effects, Millis deadline = 0,
            std::shared_ptr<const StageResult> result = nullptr);
  void index(const Job& job);
  void unindex(const Job& job);
  void extend(Job& job, Millis deadline);
  void note(EventNoted event, Effects& effects);
  void tell_experiments(const Job& job, JobState from, const std::shared_ptr<const StageResult>& result, Effects& effects);
  void refresh(ExperimentId id, Effects& effects);

  // The graph (job_queue_graph.cpp).
  Job& add_job(const Wish& wish);
  struct Place {
    JobState state;
    std::string detail;
  };
  Place place_of(const Job& job) const;  ///< BLOCKED, READY or SKIPPED: what its parent allows
  void revive(Job& job, Effects& effects);
  void release_children(const Job& parent, Effects& effects);
  bool wanted(const Job& job) const;
  void end_lease(Job& job, const std::string& outcome, const std::string& detail, Effects& effects);

  // Leases (job_queue.cpp).
  std::optional<Order> take(Worker& worker, const WorkerReport& report, Millis now, Effects& effects);
  std::optional<Order> next_for(const std::string& name, Worker& worker, Millis now, Effects& effects);
  Order on_finished(const std::string& name, Worker& worker, const WorkerFinished& done, Millis now, Effects& effects,
                    bool& settled);
  std::optional<Order> on_running(const std::string& name, const WorkerRunning& run, Millis now, Effects& effects);
  Job* leased(JobId id, LeaseToken token, const std::string& worker);
  void on_failure(Job& job, const JobFailure& failure, Millis now, Effects& effects);
  void on_lost_worker(Job& job, Millis now, Effects& effects);
  Order start_order(const Job& job) const;
  Millis backoff(const Job& job, FailureClass kind) const;

  QueuePolicy policy_;
  LeaseToken last_token_;
  std::uint64_t next_job_ = 1;
  std::uint64_t next_experiment_ = 1;
  std::unordered_map<std::uint64_t, Job> jobs_;
  std::unordered_map<std::string, JobId> by_key_;
  std::map<ExperimentId, Experiment> experiments_;
  std::vector<JobLink> links_;
  std::set<JobId> ready_;                         ///< lowest first: a point is finished before the next is begun
  std::set<std::pair<Millis, JobId>> deadlines_;  ///< of leases and pauses
  std::unordered_map<std::string, Worker> workers_;
};

}  // namespace regolab
