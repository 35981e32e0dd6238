/// A stand-in for the DEM: a stage is a long sum, with the same promises about bits, checkpoints and stopping.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "input/job_file.h"
#include "worker/stage/run_stage.h"

namespace regolab::test {

struct FakeStages {
  std::uint64_t steps = 100;  ///< of every stage
  std::uint64_t steps_between_checkpoints = 10;
  std::function<void(const StageSpec&, std::uint64_t step)> at_step = {};  ///< may request a stop
  std::function<StageEnd(const StageSpec&)> end_of = {};                   ///< completed when empty
  std::vector<StageKind> started = {};                                     ///< in order, resumed ones too
  std::uint64_t steps_done = 0;                                            ///< over all calls

  Result<StageOutput> run(const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                          const StageHooks& hooks);
};

/// Two spheres of one cluster on another, one of them on the floor.
BedView small_bed();

/// A view of what FakeStages left; kDataLoss for anything else.
Result<BedView> view_fake_bed(const std::string& bed);

/// Article test 7 with repose and two confining stresses.
Job small_job();

}  // namespace regolab::test
