/// A stage from specification to result: the one door of the DEM for the worker program. Pure: equal arguments, equal bits,
/// on any number of threads and however often it was interrupted and resumed from a checkpoint.
#pragma once
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "vocab/measurement.h"
#include "vocab/result.h"
#include "vocab/stage.h"

namespace regolab {

struct StageProgress {
  std::string_view phase;      ///< "sedimentation", "isotropic", "shear", "collapse", ...
  double fraction = 0;         ///< of the stage, 0 to 1, an estimate
  std::uint64_t steps = 0;
  double sphere_steps_per_s = 0;
};

/// Called from the thread that runs the stage; must be quick.
struct StageHooks {
  std::function<void(const StageProgress&)> on_progress;             ///< a few times a second
  std::function<void(const std::string& checkpoint)> on_checkpoint;  ///< bytes to hand back to run_stage later
  double checkpoint_every_s = 60;                                    ///< wall time
  int threads = 1;
  std::stop_token stop;                                              ///< ends the stage with StageEnd::kCancelled
};

struct StageOutput {
  StageResult result;
  std::string bed;             ///< settle stages: the settled bed's bytes; else empty
  std::string final_state;     ///< other stages: the last state, as bed bytes, for pictures
  std::uint64_t steps = 0;
  double wall_s = 0;
};

/// `bed` is the parent's bed (empty for settle); `checkpoint` what on_checkpoint once gave for this very spec, or empty.
/// Errors: kInvalidArgument (a number out of range), kDataLoss (bed or checkpoint damaged, or of another spec or version).
Result<StageOutput> run_stage(const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                              const StageHooks& hooks);

/// Limits checked before anything is allocated: text of the first breach, empty when fine.
std::string breach_of(const StageSpec& spec);

/// A bed's spheres in space, for writers and viewers. SI.
struct SphereView {
  int cluster;
  double x, y, z, radius;
  double vx, vy, vz;           ///< of the sphere's centre
};
struct ContactView {
  int sphere_a, sphere_b;      ///< indices into spheres; sphere_b = -1 - wall for a wall
  double x, y, z;              ///< contact point [m]
  double normal_force;         ///< [N]
};
struct BedView {
  double length, width, height;   ///< of the box; height = highest sphere surface [m]
  int clusters;
  std::vector<SphereView> spheres;
  std::vector<ContactView> contacts;
};
Result<BedView> view_bed(const std::string& bed);

}  // namespace regolab
