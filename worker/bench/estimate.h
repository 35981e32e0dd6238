/// How long a study takes: the steps that stages took, times what a step costs on this machine.
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "vocab/stage.h"

namespace regolab::bench {

struct Range {
  double mean = 0, least = 0, most = 0;
};

/// One kind of stage under a profile, over the 32 materials of the article's Table 2.
struct StageSteps {
  StageKind kind;
  int per_material;  ///< such stages in one material's tests
  Range thousands;   ///< steps of one stage [1000]
};

struct ProfileSteps {
  std::string_view profile;
  std::string_view source;           ///< how the steps are known
  std::array<StageSteps, 3> stages;  ///< settle, repose, stress; fabric takes none
  Range material;                    ///< all stages of one material [1000 steps]
};

/// Empty for a name that is no profile.
std::optional<ProfileSteps> steps_of_profile(std::string_view profile);

/// What a cluster-step of a stage costs, over that of the timed bed near rest: mean over the article's 32 materials
/// under `quick`. Of the same stages by kind, materials differ by a third.
double load_of(StageKind kind);

struct Estimate {
  std::array<Range, 3> stage_s;  ///< one stage of each kind, in the profile's order [s]
  Range material_s;              ///< one material, all its stages [s]
};

/// Times of one core. `us_per_cluster_step` is this machine's.
Estimate estimate(const ProfileSteps& profile, int clusters, double us_per_cluster_step);

}  // namespace regolab::bench
