/// The words worker and queue exchange: the worker says what it runs, the queue answers what it should run.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "vocab/job.h"

namespace regolab {

enum class FailureClass {
  kTransient = 0,  ///< may go better next time: tried again after a pause
  kPermanent = 1,  ///< the same inputs would fail again
  kResource = 2,   ///< memory or disk was short: tried again after a longer pause
  kPreempted = 3,  ///< the worker was told to stop: not the job's fault, not counted
};

struct JobFailure {
  FailureClass kind = FailureClass::kTransient;
  std::string text;
};

struct JobProgress {
  std::string phase;
  double fraction = 0;  ///< of the stage, 0 to 1
  std::uint64_t steps = 0;
  double sphere_steps_per_s = 0;
};

struct WorkerIdle {};
struct WorkerRunning {
  JobId job{};
  LeaseToken token{};
  JobProgress progress;
  std::string checkpoint;  ///< digest of an artifact that exists, or empty
};
struct WorkerFinished {
  JobId job{};
  LeaseToken token{};
  std::variant<std::shared_ptr<const StageResult>, JobFailure> outcome;
  std::string bed;  ///< digest of an artifact that exists; settle stages that completed
  double wall_s = 0;
  std::uint64_t steps = 0;
};

struct WorkerReport {
  std::string worker;     ///< unique per process
  std::uint64_t seq = 0;  ///< rises by one per new report; a repeated one gets the remembered answer
  bool draining = false;  ///< takes nothing new
  std::variant<WorkerIdle, WorkerRunning, WorkerFinished> slot;
};

struct OrderStart {
  JobId job{};
  LeaseToken token{};
  StageSpec spec;
  std::string bed;         ///< digest, empty for settle
  std::string checkpoint;  ///< digest, empty if none
};
struct OrderKeep {};  ///< go on; when idle: nothing to do
struct OrderDrop {    ///< stop: cancelled, or the lease is stale
  std::string why;
};
struct OrderLeave {};  ///< exit
using Order = std::variant<OrderStart, OrderKeep, OrderDrop, OrderLeave>;

}  // namespace regolab
