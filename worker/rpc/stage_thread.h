/// Runs one stage on a thread of its own: fetches what it starts from, keeps its checkpoints and bed safe with the
/// scheduler, and says when it is done.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "worker/stage/run_stage.h"

namespace regolab {

using StageFunction = std::function<Result<StageOutput>(const StageSpec&, const std::string& bed,
                                                        const std::string& checkpoint, const StageHooks&)>;

/// Where artifacts go. Calls may take long; they give up with kUnavailable, kResourceExhausted, ...
struct ArtifactDoor {
  std::function<Result<std::string>(const std::string& digest)> get;
  std::function<Result<std::string>(const std::string& bytes)> put;  ///< digest
};

struct StageOrder {
  StageSpec spec;
  std::string bed;         ///< digest, empty for settle
  std::string checkpoint;  ///< digest, empty if none
};

struct StageReport {
  std::string phase = "fetching";
  double fraction = 0;
  std::uint64_t steps = 0;
  double sphere_steps_per_s = 0;
  std::string checkpoint;  ///< digest of the newest one that is safe
};

class StageThread {
 public:
  struct Options {
    int threads = 1;
    double checkpoint_every_s = 60;
  };
  struct Outcome {
    Result<StageOutput> output = Error{};
    std::string bed;  ///< digest, completed settle stages
  };

  /// `on_done` is called once, from the thread, when outcome() is ready.
  StageThread(StageOrder order, StageFunction run, ArtifactDoor door, Options options, std::function<void()> on_done);
  ~StageThread();  ///< stops the stage and waits

  /// The stage gives a last checkpoint and ends as kCancelled; transfers end.
  void stop();
  bool done() const;
  StageReport report() const;
  /// REQUIRES: done(). Waits until the last checkpoint is safe or `patience` has passed.
  Outcome take(std::chrono::milliseconds patience);

 private:
  void work(const std::stop_token& stop);
  Outcome run(const std::stop_token& stop);
  void keep_checkpoints(const std::stop_token& stop);
  /// Repeats `call` with growing pauses while the scheduler is away or its disk is full.
  Result<std::string> patiently(const std::stop_token& stop, const std::function<Result<std::string>()>& call);

  const StageOrder order_;
  const StageFunction run_;
  const ArtifactDoor door_;
  const Options options_;
  const std::function<void()> on_done_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  StageReport report_;                  ///< guarded by mutex_
  std::optional<std::string> to_keep_;  ///< newest checkpoint not yet uploaded; guarded by mutex_
  bool keeping_ = false;                ///< an upload is under way; guarded by mutex_
  std::optional<Outcome> outcome_;      ///< guarded by mutex_
  std::jthread keeper_, worker_;        ///< last: they use all of the above
};

}  // namespace regolab
