/// What a step of the queue asks the world to do. Applying all effects in order to empty tables gives the tables.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "scheduler/queue/exchange.h"
#include "vocab/job.h"

namespace regolab {

enum class EventKind { kSubmitted, kJob, kRetry, kEnded };

struct JobAdded {
  JobRecord record;
};
struct JobChanged {
  JobId job{};
  JobStatus status;
};
struct Linked {
  JobLink link;
};
struct ExperimentChanged {
  ExperimentId experiment{};
  ExperimentState state{};
};
struct AttemptStarted {
  JobId job{};
  LeaseToken token{};
  std::string worker;
};
struct AttemptEnded {
  LeaseToken token{};
  std::string outcome;  ///< "result", "transient", "permanent", "resource", "preempted", "lost", "cancelled"
  std::string detail;
};
/// To be committed only if `token` is still the job's newest lease; comes before the JobChanged that ends the lease.
struct ResultAccepted {
  JobId job{};
  LeaseToken token{};
  std::shared_ptr<const StageResult> result;
  double wall_s = 0;
  std::uint64_t steps = 0;
};
struct ResultForgotten {  ///< the bed that went with it is gone; the stage runs again
  JobId job{};
};
/// Numbered from 1 without gaps per experiment.
struct EventNoted {
  ExperimentId experiment{};
  std::uint64_t seq = 0;
  EventKind kind{};
  JobId job{};  ///< with point, seed and state: kJob and kRetry only
  int point = 0;
  std::uint64_t seed = 0;
  JobState state{};
  std::string detail = {};
  std::shared_ptr<const StageResult> result = {};  ///< of a job that just succeeded
};
/// Not to be stored: the worker's call should be answered now.
struct LeaseRevoked {
  std::string worker;
  JobId job{};
};

using Effect = std::variant<JobAdded, JobChanged, Linked, ExperimentChanged, AttemptStarted, AttemptEnded, ResultAccepted,
                            ResultForgotten, EventNoted, LeaseRevoked>;
using Effects = std::vector<Effect>;

template <class T>
void emit(Effects& effects, T effect) {
  effects.emplace_back(std::in_place_type<T>, std::move(effect));
}

}  // namespace regolab
