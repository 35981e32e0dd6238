/// A stand-in for run_stage() of worker/stage: numbers made from the stage's canonical text alone, so that equal stages give
/// equal bits and another order of steps gives others. Interruptible, resumable, as slow as asked.
#pragma once
#include "worker/stage/run_stage.h"

namespace regolab::test {

struct FakeStage {
  double duration_s = 0.05;         ///< of a stage; fabric takes none
  std::uint64_t poison_seed = 0;    ///< repose stages of this seed kill their process halfway; 0 = none
  std::uint64_t broken_seed = 0;    ///< fabric stages of this seed are refused as kInvalidArgument
  std::uint64_t restless_seed = 0;  ///< settle stages of this seed end as kNotSettled

  Result<StageOutput> operator()(const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                                 const StageHooks& hooks) const;
};

}  // namespace regolab::test
