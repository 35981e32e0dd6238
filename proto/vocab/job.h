/// A stage as the queue and the store know it: who it is, where it stands.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "vocab/measurement.h"
#include "vocab/stage.h"

namespace regolab {

enum class JobId : std::uint64_t {};         ///< 0 = none
enum class ExperimentId : std::uint64_t {};  ///< 0 = none
enum class LeaseToken : std::uint64_t {};  ///< boot epoch in the high bits, a counter in the low 28; never handed out twice

enum class JobState {
  kBlocked = 0,      ///< its parent has not succeeded yet
  kReady = 1,        ///< may be given to a worker
  kLeased = 2,       ///< a worker has it, until the lease ends
  kBackoff = 3,      ///< waits before it is tried again
  kSucceeded = 4,    ///< its result is stored; the simulation may have ended unphysically (StageEnd)
  kFailed = 5,       ///< the run could not be made
  kSkipped = 6,      ///< its parent left no bed to start from
  kCancelled = 7,    ///< no experiment wants it any more
  kQuarantined = 8,  ///< its workers died again and again
};

inline constexpr bool is_final(JobState state) { return state >= JobState::kSucceeded; }

inline constexpr std::string_view kJobStateNames[] = {"blocked", "ready",   "leased",    "backoff",    "succeeded",
                                                      "failed",  "skipped", "cancelled", "quarantined"};
inline std::string_view name_of(JobState state) { return kJobStateNames[static_cast<int>(state)]; }

/// What never changes of a job.
struct JobIdentity {
  JobId id{};
  std::string key;  ///< stage_key, 64 lower-case hex digits
  StageSpec spec;
  JobId parent = {};  ///< the settle stage it starts from
};

/// What changes, and survives a restart.
struct JobStatus {
  JobState state = JobState::kBlocked;
  LeaseToken token{};             ///< of the newest lease
  std::string worker;             ///< holder of the newest lease
  int attempts = 0;               ///< failures counted so far
  int deaths = 0;                 ///< workers lost in a row at the same place, without a new checkpoint
  int deaths_anywhere = 0;        ///< workers lost, wherever they were
  std::uint64_t death_steps = 0;  ///< where the last of them was heard [steps]
  std::string detail;             ///< why it stands so; problem (why) remedy
  std::string bed;                ///< digest, settle stages that succeeded
  std::string checkpoint;         ///< digest of the newest one, empty if none
  std::optional<StageEnd> end;    ///< once succeeded
  double wall_s = 0;              ///< of the successful run
  std::uint64_t steps = 0;

  bool operator==(const JobStatus&) const = default;
};

struct JobRecord {
  JobIdentity identity;
  JobStatus status;
};

enum class ExperimentState { kRunning = 0, kDone = 1, kFailed = 2, kCancelled = 3 };
inline constexpr std::string_view kExperimentStateNames[] = {"running", "done", "failed", "cancelled"};
inline std::string_view name_of(ExperimentState state) { return kExperimentStateNames[static_cast<int>(state)]; }

/// Where a job stands in an experiment. One job may stand at several places, in several experiments.
struct JobLink {
  ExperimentId experiment{};
  JobId job{};
  int point = 0;  ///< 1-based row of the design
  std::uint64_t seed = 0;
  bool reused = false;  ///< its result was stored before the experiment was submitted
};

}  // namespace regolab
