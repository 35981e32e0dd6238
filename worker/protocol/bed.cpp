#include "worker/protocol/bed.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "vocab/canonical.h"
#include "worker/dem/watch.h"
#include "worker/effects/contact.h"
#include "worker/effects/strengths.h"
#include "worker/generate/replacement.h"

namespace regolab::protocol {
namespace {

constexpr double kFillFractions[] = {0.3, 0.25, 0.2, 0.15, 0.1};  // of spheres; about 0.3 [protocols, section 1], less where
                                                                  // a narrow base leaves the large ones no room
constexpr double kClearance = 0.02;     // between parents, and to the walls: four-sphere clusters stick out by up to 1 %

void raise_walls(Bed& bed) {
  const double friction = effects::settling_friction_share(bed.effects) * std::tan(bed.micro.friction_angle);
  const double sides = effects::wall_friction(bed.effects);
  auto& walls = bed.world.walls;
  walls[dem::kLeft] = {.present = true, .position = 0, .friction = sides};
  walls[dem::kRight] = {.present = true, .position = bed.length, .friction = sides};
  walls[dem::kFront] = {.present = true, .position = 0, .friction = sides};
  walls[dem::kBack] = {.present = true, .position = bed.width, .friction = sides};
  walls[dem::kFloor] = {.present = true, .position = 0, .friction = friction};
}

}  // namespace

dem::LinearLaw softened_law(const Bed& bed, double most) {
  const Micro& micro = bed.micro;
  const double factor = most > 0 ? std::min(1.0, most / micro.normal_stiffness) : 1.0;
  dem::LinearLaw law;
  law.normal_stiffness = factor * micro.normal_stiffness;
  law.tangential_stiffness = factor * micro.tangential_stiffness;
  law.friction = std::tan(micro.friction_angle);
  law.most_damping_ratio = bed.most_damping_ratio;
  law.damping_is_ratio = micro.damping_unit == DampingUnit::kRatio;
  if (law.damping_is_ratio) {
    law.normal_damping = 2 * micro.normal_damping * std::sqrt(law.normal_stiffness);
    law.tangential_damping = 2 * micro.tangential_damping * std::sqrt(law.tangential_stiffness);
  } else {
    law.normal_damping = std::sqrt(factor) * micro.normal_damping;
    law.tangential_damping = std::sqrt(factor) * micro.tangential_damping;
  }
  return law;
}

dem::LinearLaw settling_law(const Bed& bed, double kappa, double gravity_ratio) {
  const double pressure = gravity_ratio * bed.pressure();
  dem::LinearLaw law = softened_law(bed, kappa > 0 ? kappa * (pressure + effects::attraction_pressure(bed.effects)) * bed.mean_diameter() : 0);
  law.effects = effects::contact_effects(bed.effects, {.pressure = pressure,
                                                       .mean_diameter = bed.mean_diameter(),
                                                       .stiffness = law.normal_stiffness,
                                                       .largest_load = effects::kLargestSettlingLoad});
  return law;
}

double Bed::wall_dashpot() const {
  const double mean_mass = micro.grain_density * solid_volume / world.bodies.count();
  const dem::LinearLaw law = dem::at_walls(world.law);
  return dem::Dashpot(law, law.normal_stiffness, law.normal_damping).eta(std::sqrt(mean_mass));
}

void renew_step(Bed& bed) { bed.world.dt = dem::stable_step(bed.world, bed.step_fraction); }

std::string generate_bed(const StageSpec& spec, Bed& bed) {
  const Base base = base_of(spec);
  bed.micro = spec.micro;
  bed.effects = spec.effects;
  bed.length = base.length;
  bed.width = base.width;
  bed.step_fraction = spec.numerics.step_fraction;
  bed.most_damping_ratio = spec.numerics.most_damping_ratio;
  const generate::Random random(spec.seed);
  const auto diameters = generate::parent_diameters(spec.numerics.clusters, spec.micro.largest_diameter, random,
                                                    spec.effects[EffectId::kSizeDistribution]);
  std::optional<generate::Parents> parents;
  for (const double fraction : kFillFractions) {
    if (!parents) parents = generate::place_parents(diameters, bed.length, bed.width, fraction, kClearance, random);
  }
  if (!parents) {
    return "the parent spheres found no room (box " + std::to_string(bed.length) + " m x " + std::to_string(bed.width) +
           " m is too narrow for L_S = " + std::to_string(spec.micro.largest_diameter) + " m) widen the box";
  }
  generate::replace_parents(*parents, spec.micro, spec.numerics.mass_floor, random, bed.world);
  const auto& volumes = bed.world.bodies.solid_volume;
  bed.solid_volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  if (generate::deepest_overlap_between_clusters(bed.world) > 0) {
    return "clusters overlap after replacement (a broken promise of the generator) report the job file";
  }
  raise_walls(bed);
  const double gravity_ratio = effects::settling_gravity_ratio(spec.effects);
  bed.world.law = settling_law(bed, spec.numerics.settle_stiffness_number, gravity_ratio);
  bed.world.law.friction *= effects::settling_friction_share(spec.effects);
  bed.world.gravity = gravity_ratio * spec.micro.gravity;
  bed.world.skin = 0.05 * spec.micro.largest_diameter;
  renew_step(bed);
  return {};
}

}  // namespace regolab::protocol
