#include "worker/bench/bed.h"

#include <algorithm>
#include <cmath>

#include "vocab/micro.h"
#include "vocab/units.h"
#include "worker/dem/step.h"
#include "worker/generate/replacement.h"

namespace regolab::bench {
namespace {

constexpr double kLargest = 0.01;       // L_S [m]
constexpr double kDensity = 2930;       // [kg/m3]
constexpr double kLunarGravity = 1.63;  // [m/s2]
constexpr double kFillFraction = 0.30, kClearance = 0.02;

constexpr double kDropGravity = 50;                  // [m/s2]: the cloud, 0.3 m high, is down in 0.11 s
constexpr double kLooseDrag = 20, kTightDrag = 100;  // [1/s]: grains sink at g / drag, then come to rest
constexpr int kDropSteps = 80000, kLooseSteps = 50000, kTightSteps = 20000, kFreeSteps = 20000;  // 0.16, 0.10, 0.04, 0.02 s

void add_plain_spheres(const generate::Parents& parents, dem::World& world) {
  for (std::size_t i = 0; i < parents.centre.size(); ++i) {
    dem::add_cluster({.centre = {parents.centre[i]},
                      .radius = {parents.radius[i]},
                      .density = kDensity,
                      .parent_diameter = 2 * parents.radius[i]},
                     world.bodies, world.spheres);
  }
}

}  // namespace

void furnish(double length, double width, dem::World& world) {
  const double friction = std::tan(40 * kDegree);
  world.law = {.normal_stiffness = 7.5e4,
               .normal_damping = 0.25,
               .tangential_stiffness = 7.5e4,
               .tangential_damping = 0.25,
               .friction = friction};
  world.walls[dem::kLeft] = {.present = true, .position = 0, .friction = friction};
  world.walls[dem::kRight] = {.present = true, .position = length, .friction = friction};
  world.walls[dem::kFront] = {.present = true, .position = 0, .friction = friction};
  world.walls[dem::kBack] = {.present = true, .position = width, .friction = friction};
  world.walls[dem::kFloor] = {.present = true, .position = 0, .friction = friction};
  world.gravity = kLunarGravity;
  world.dt = kSteadyStep;
  world.skin = 0.05 * kLargest;  // as the protocols have it
}

std::optional<dem::World> cloud(const BedPlan& plan) {
  const generate::Random random(plan.seed);
  const auto parents = generate::place_parents(generate::parent_diameters(plan.clusters, kLargest, random), plan.width,
                                               plan.width, kFillFraction, kClearance, random);
  if (!parents) return std::nullopt;
  dem::World world;
  if (plan.spheres_each == 1) {
    add_plain_spheres(*parents, world);
  } else {
    const Micro micro{.largest_diameter = kLargest,
                      .kind = static_cast<ParticleKind>(plan.spheres_each),
                      .rotation = Rotation::kXZ,
                      .grain_density = kDensity};
    generate::replace_parents(*parents, micro, 0, random, world);
  }
  furnish(plan.width, plan.width, world);
  return world;
}

void advance(int steps, dem::World& world, const OnProgress& on_progress) {
  constexpr int kStepsPerLook = 500;
  for (int i = 0; i < steps; ++i) {
    dem::step(world);
    if (on_progress && i % kStepsPerLook == 0) on_progress(static_cast<double>(i) / steps);
  }
}

void settle(dem::World& world, const OnProgress& on_progress) {
  constexpr double kAll = kDropSteps + kLooseSteps + kTightSteps + kFreeSteps;
  int done = 0;
  const auto stretch = [&](int steps) {
    advance(steps, world, [&](double fraction) {
      if (on_progress) on_progress((done + fraction * steps) / kAll);
    });
    done += steps;
  };
  dem::compute_forces(world);
  world.dt = kFastStep;
  world.gravity = kDropGravity;
  stretch(kDropSteps);
  world.gravity = kLunarGravity;
  world.drag = kLooseDrag;
  stretch(kLooseSteps);
  world.drag = kTightDrag;
  stretch(kTightSteps);
  world.drag = 0;
  world.dt = kSteadyStep;
  stretch(kFreeSteps);
}

}  // namespace regolab::bench
