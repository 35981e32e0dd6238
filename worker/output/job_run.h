/// A job from its file to its results, stage after stage, on this machine alone.
#pragma once
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "input/job_file.h"
#include "vocab/result.h"
#include "worker/output/stage_store.h"
#include "worker/stage/run_stage.h"

namespace regolab {

/// Where in its job a stage stands.
struct StagePlace {
  StageSpec spec;
  std::size_t number;  ///< 1-based
  std::size_t count;
};

struct JobHooks {
  std::function<Result<StageOutput>(const StageSpec&, const std::string& bed, const std::string& checkpoint,
                                    const StageHooks&)>
      run_stage;                                                                  ///< regolab::run_stage, or a test's
  std::function<void(const StagePlace&, const StageProgress&)> on_progress = {};  ///< a few times a second
  std::function<void(const StagePlace&, const FinishedStage&)> on_finished = {};  ///< also for stages kept from before
  std::function<void(const std::string&)> on_note = {};                           ///< something a person should know
  int threads = 1;
  double checkpoint_every_s = 60;
  std::stop_token stop = {};
};

struct JobRun {
  std::vector<KeptStage> stages;  ///< in the order they ran; ends early when settling did not complete
  bool interrupted = false;       ///< stopped on request; what was done is kept
};

/// Skips the stages that `store` has, resumes the one it has a checkpoint of. An unphysical end is a result, not an error;
/// without a settled bed the later stages are not run. Errors: those of run_stage and of StageStore's writing.
Result<JobRun> run_job(const Job& job, const StageStore& store, const JobHooks& hooks);

}  // namespace regolab
