#include "worker/protocol/guard.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/watch.h"

namespace regolab::protocol {
namespace {

constexpr double kMostGain = 0.02;     // of the energy scale: the error budget of the integrator
constexpr double kMostOverlap = 1.5;   // over the smaller radius: beyond, spheres pass through each other

std::string percent(double share) { return std::to_string(100 * share) + " %"; }

/// A present cluster outside the walls by more than the margin; -1 when none.
int lost_cluster(const Bed& bed, double margin) {
  const auto& b = bed.world.bodies;
  const auto& walls = bed.world.walls;
  for (int i = 0; i < b.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (b.gone[k]) continue;
    const double at[3] = {b.x[k], b.y[k], b.z[k]};
    for (int w = 0; w < dem::kWalls; ++w) {
      if (!walls[w].present || (w == dem::kFloor && b.x[k] > walls.floor_end)) continue;
      if (dem::inward(w) * (at[dem::axis_of(w)] - walls[w].position) < -margin) return i;
    }
  }
  return -1;
}

}  // namespace

void Guard::begin(const dem::World& world) {
  allowance = dem::energies(world).total() - world.wall_work;
  scale = 0;
}

std::optional<Ending> Guard::look(const Bed& bed, double margin) {
  const dem::World& world = bed.world;
  if (!dem::finite(world)) {
    return Ending{StageEnd::kUnstable, "a velocity is not finite (the step of " + std::to_string(world.dt) +
                                           " s is too long for these contacts) lower step_fraction"};
  }
  const dem::Energies energy = dem::energies(world);
  scale = std::max(scale, energy.kinetic + energy.elastic - energy.attraction);
  const double gain = energy.total() - allowance - world.wall_work;
  const double reference = scale + std::abs(world.wall_work);
  if (reference > 0) worst_gain = std::max(worst_gain, gain / reference);
  if (gain > kMostGain * reference) {
    return Ending{StageEnd::kEnergyGrowth, "mechanical energy grew by " + percent(gain / reference) +
                                               " beyond the work put in (the step is too long for these contacts) lower "
                                               "step_fraction"};
  }
  const double overlap = dem::deepest_overlap(world);
  deepest = std::max(deepest, overlap);
  if (overlap > kMostOverlap) {
    return Ending{StageEnd::kOverlap, "an overlap reached " + percent(overlap) +
                                          " of a radius (the springs are too soft for this load) raise the stiffness number"};
  }
  if (const int lost = lost_cluster(bed, margin); lost >= 0) {
    return Ending{StageEnd::kLostCluster, "cluster " + std::to_string(lost) +
                                              " left the box through a wall (too soft or too long a step) lower step_fraction"};
  }
  return std::nullopt;
}

}  // namespace regolab::protocol
