/// Watching an experiment to its end, over lost connections.
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "client/console.h"
#include "client/lab.h"
#include "client/outcome.h"

namespace regolab::client {

struct FollowOptions {
  std::uint64_t from_seq = 0;                                ///< first event wanted
  double timeout_s = 0;                                      ///< 0 = none
  bool verbose = false;                                      ///< a line for every event
  std::chrono::seconds patience{300};                        ///< how long to try again when the scheduler is away
  std::function<void(const pb::WatchEvent&)> on_event = {};  ///< events proper, no heartbeats
};

/// `last` is the newest status seen, and `options.from_seq` the next event wanted, however it went.
Outcome follow(Lab& lab, const std::string& experiment, FollowOptions& options, Console& console,
               pb::ExperimentStatus& last);

/// kTrialsFailed when jobs failed, were skipped or left a reason instead of numbers.
Outcome verdict_of(const pb::ExperimentStatus& status);

bool has_ended(const pb::ExperimentStatus& status);

}  // namespace regolab::client
