#include "worker/output/finished_stage.h"

#include "digest/sha256.h"

namespace regolab {

std::vector<StageSpec> stages_of(const Job& job) {
  const StageSpec settle{.kind = StageKind::kSettle, .micro = job.micro, .numerics = job.numerics, .seed = job.seed,
                         .effects = acting_in(job.effects, StageKind::kSettle)};
  std::vector<StageSpec> stages{settle};
  const auto add = [&](StageKind kind, double confining_stress, const PlateSize& plate = {}) {
    StageSpec spec = settle;
    spec.kind = kind;
    spec.confining_stress = confining_stress;
    spec.plate = plate;
    spec.effects = acting_in(job.effects, kind);
    stages.push_back(spec);
  };
  add(StageKind::kFabric, 0);
  if (job.repose) add(StageKind::kRepose, 0);
  for (const double sigma3 : job.confining_stresses) add(StageKind::kStress, sigma3);
  for (const PlateSize& plate : job.plates) add(StageKind::kPenetration, 0, plate);
  return stages;
}

std::string stage_name(StageKind kind) { return std::string(name_of(kind)); }

std::string job_key(const Job& job) {
  std::string keys;
  for (const StageSpec& spec : stages_of(job)) keys += stage_key(spec) + "\n";
  return sha256_hex(keys);
}

std::string program_version() { return REGOLAB_VERSION; }

}  // namespace regolab
