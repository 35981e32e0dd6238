/// A whole laboratory in one thread and virtual time: workers that crash, pause and repeat themselves, a network that
/// loses, doubles and reorders, a scheduler that dies before or after its commits. Replays from its seed.
#pragma once
#include <map>
#include <memory>
#include <queue>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/tables.h"
#include "support/wishes.h"

namespace regolab::test {

struct Faults {
  double lose = 0, twice = 0;  ///< share of messages
  Millis slowest = 20;         ///< longest way of a message; differing ways reorder
  double worker_crash = 0, worker_pause = 0, scheduler_crash = 0, commit_fails = 0, bed_loss = 0;  ///< per message handled
  double transient = 0;                                                                            ///< share of runs
};

class VirtualLab {
 public:
  VirtualLab(std::uint64_t seed, int workers);

  void submit(const std::vector<Wish>& wishes);  ///< repeated until acknowledged
  void cancel_last();
  void run(Millis until, const Faults& faults);
  /// True once every experiment has ended.
  bool quiet() const;
  void check_end();

  Tables tables;
  int crashes = 0, restarts = 0, refused = 0;
  Millis now = 0;

  static bool poison(const StageSpec& spec) { return spec.seed % 17 == 5 && spec.kind == StageKind::kRepose; }
  static bool broken(const StageSpec& spec) { return spec.seed % 13 == 7 && spec.kind == StageKind::kFabric; }
  static bool unphysical(const StageSpec& spec) { return spec.seed % 11 == 3 && spec.kind == StageKind::kSettle; }
  static StageResult truth(const StageSpec& spec);

 private:
  struct Machine {  // a worker process; its name never comes back
    std::string name;
    std::uint64_t seq = 0;
    WorkerReport report;
    std::optional<OrderStart> job;
    Millis begun = 0, paused_until = 0, spoke = 0;
    bool waiting = false;
  };
  struct Message {
    Millis at;
    std::uint64_t order;
    bool to_scheduler;
    WorkerReport report;  ///< and for answers: worker and seq
    Order answer;
    bool operator<(const Message& other) const { return std::tie(other.at, other.order) < std::tie(at, order); }
  };

  bool chance(double share) { return std::uniform_real_distribution<>{}(random_) < share; }
  Millis way(const Faults& f) { return 1 + static_cast<Millis>(random_() % static_cast<std::uint64_t>(f.slowest)); }
  void send(Message message, const Faults& f);
  void scheduler_hears(const Message& message, const Faults& f);
  void answer(const WorkerReport& report, const Order& order, const Faults& f);
  void worker_hears(Machine& machine, const Message& message, const Faults& f);
  void worker_acts(Machine& machine, const Faults& f);
  WorkerReport say(Machine& machine, decltype(WorkerReport::slot) slot);
  bool commit(Effects& effects, const Faults& f);
  void reload();
  void replace(Machine& machine);
  void check();

  std::mt19937_64 random_;
  QueuePolicy policy_{.lease_ttl = 1000, .max_attempts = 8, .first_backoff = 50, .longest_backoff = 500};
  JobQueue queue_;
  std::vector<Machine> machines_;
  std::priority_queue<Message> network_;
  std::map<std::string, WorkerReport> held_;  ///< long polls
  std::map<ExperimentId, std::size_t> results_at_cancel_;
  std::set<JobId> dead_;  ///< cancelled and acknowledged: nothing may commit for them
  std::uint64_t order_ = 0;
  int born_ = 0;
};

}  // namespace regolab::test
