/// Small studies for tests: stages that differ only in seed and confining stress.
#pragma once
#include <vector>

#include "digest/sha256.h"
#include "scheduler/queue/job_queue.h"

namespace regolab::test {

inline StageSpec stage(StageKind kind, std::uint64_t seed, double confining_stress = 0) {
  StageSpec spec;
  spec.kind = kind;
  spec.seed = seed;
  spec.confining_stress = confining_stress;
  spec.micro = {.friction_angle = 0.3,
                .normal_stiffness = 1e5,
                .normal_damping = 0.25,
                .tangential_stiffness = 7.5e4,
                .tangential_damping = 1,
                .largest_diameter = 0.01};
  return spec;
}

inline Wish wish(int point, const StageSpec& spec) {
  return {.point = point,
          .seed = spec.seed,
          .spec = spec,
          .key = stage_key(spec),
          .parent_key = needs_bed(spec.kind) ? stage_key(parent_of(spec)) : std::string{}};
}

/// Per point one bed and, on it, fabric, repose and `stresses` stress tests. Point p has seed first_seed + p - 1.
inline std::vector<Wish> study(int points, std::uint64_t first_seed = 1, int stresses = 2) {
  std::vector<Wish> wishes;
  for (int point = 1; point <= points; ++point) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(point) - 1;
    wishes.push_back(wish(point, stage(StageKind::kSettle, seed)));
    wishes.push_back(wish(point, stage(StageKind::kFabric, seed)));
    wishes.push_back(wish(point, stage(StageKind::kRepose, seed)));
    for (int i = 0; i < stresses; ++i) wishes.push_back(wish(point, stage(StageKind::kStress, seed, 1250.0 * (i + 1))));
  }
  return wishes;
}

}  // namespace regolab::test
