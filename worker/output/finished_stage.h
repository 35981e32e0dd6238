/// One stage of a job, done: what went in and what came out.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "input/job_file.h"
#include "vocab/measurement.h"
#include "vocab/stage.h"

namespace regolab {

struct FinishedStage {
  StageSpec spec;
  StageResult result;
  std::uint64_t steps = 0;
  double wall_s = 0;
};

/// The stages of a job in the order they run: settle, fabric, repose, stress by confining stress, penetration by plate.
std::vector<StageSpec> stages_of(const Job& job);

/// For people: "settle", "fabric", "repose", "stress", "penetration".
std::string stage_name(StageKind kind);

/// One name for the whole job: the SHA-256 of its stages' keys.
std::string job_key(const Job& job);

/// The release, as `regolab-worker --version` prints it.
std::string program_version();

}  // namespace regolab
