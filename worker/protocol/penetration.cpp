#include "worker/protocol/penetration.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/step.h"
#include "worker/dem/watch.h"
#include "worker/effects/strengths.h"
#include "worker/protocol/surface.h"

namespace regolab::protocol {
namespace {

constexpr int kStepsPerLook = 250;
constexpr double kInterval = 5e-4;       // of depth between samples [m] [protocols, section 8]
constexpr double kFewestIntervals = 40;  // over the height of a shallow bed
constexpr double kToDepth = 0.5;         // of the mean bed height

/// Height of a plate's edge that first touches a sphere when it comes down on the footprint [m].
double first_touch(const Bed& bed, const PlateSize& plate) {
  const dem::World& w = bed.world;
  const dem::Centres at = dem::sphere_centres(w.bodies, w.spheres);
  double touch = 0;
  for (std::size_t i = 0; i < at.x.size(); ++i) {
    if (w.bodies.gone[static_cast<std::size_t>(w.spheres.body[i])]) continue;
    const double ox = std::max(0.0, std::abs(at.x[i] - 0.5 * bed.length) - 0.5 * plate.width);
    const double oy = std::max(0.0, std::abs(at.y[i] - 0.5 * bed.width) - 0.5 * plate.thickness);
    const double rest = w.spheres.radius[i] * w.spheres.radius[i] - ox * ox - oy * oy;
    if (rest > 0) touch = std::max(touch, at.z[i] + std::sqrt(rest));
  }
  return touch;
}

/// Pressure of the grains above the depth where the plate ends, half the bed's weight on its base [Pa].
double end_pressure(const Bed& bed) { return kToDepth * dem::weight(bed.world, bed.micro.gravity) / (bed.length * bed.width); }

}  // namespace

Penetration::Penetration(Bed bed, const StageSpec& spec)
    : bed_(std::move(bed)), plate_(spec.plate), inertial_number_(effects::rate_factor(spec.effects) * spec.numerics.inertial_number) {}

/// I = (v/d) d sqrt(rho/p): grains of mean diameter d beside the plate are sheared at about v/d, under the pressure p at the final depth.
void Penetration::bring_plate() {
  dem::World& w = bed_.world;
  start_step_ = w.step;
  surface_ = mean_height(bed_);
  speed_ = inertial_number_ * std::sqrt(end_pressure(bed_) / bed_.micro.grain_density);
  interval_ = std::min(kInterval, surface_ / kFewestIntervals);
  first_ = next_ = static_cast<int>(std::floor(std::min(0.0, surface_ - first_touch(bed_, plate_)) / interval_));
  ++next_;
  last_ = static_cast<int>(std::floor(kToDepth * surface_ / interval_));
  const double half_height = 0.5 * (surface_ + 2 * bed_.micro.largest_diameter);  // nothing gets over its top
  w.walls.plate = {.x = 0.5 * bed_.length, .y = 0.5 * bed_.width, .half = {0.5 * plate_.width, 0.5 * plate_.thickness, half_height}};
  w.walls[dem::kPlate] = {.present = true,
                          .position = surface_ - first_ * interval_ + half_height,
                          .velocity = -speed_,
                          .friction = effects::plate_friction(bed_.effects, std::tan(bed_.micro.friction_angle))};
  w.gravity *= effects::density_ratio(bed_.effects);  // heavier grains, as far as statics can tell
  dem::compute_forces(w);
  guard_.begin(w);
}

double Penetration::depth() const {
  const dem::Walls& walls = bed_.world.walls;
  return surface_ - (walls[dem::kPlate].position - walls.plate.half[2]);
}

void Penetration::note() {
  const dem::Walls& walls = bed_.world.walls;
  sum_.force += walls.plate.force[2];
  sum_.contacts += walls[dem::kPlate].contacts;
  ++sum_steps_;
}

void Penetration::close_interval() {
  samples_.push_back({.depth = (next_ - 0.5) * interval_,
                      .force = sum_.force / sum_steps_,
                      .contacts = sum_.contacts / sum_steps_,
                      .unbalanced = dem::unbalanced_force_ratio(bed_.world)});
  sum_ = {};
  sum_steps_ = 0;
  ++next_;
}

std::optional<Ending> Penetration::advance() {
  if (!started_) {
    bring_plate();
    started_ = true;
  }
  for (int i = 0; i < kStepsPerLook; ++i) {
    dem::step(bed_.world);
    note();
    if (depth() >= next_ * interval_) close_interval();
    if (next_ > last_) return Ending{};
  }
  return guard_.look(bed_, bed_.micro.largest_diameter);
}

double Penetration::fraction() const {
  if (!started_ || last_ <= first_) return 0;
  return std::clamp((depth() / interval_ - first_) / (last_ - first_), 0.0, 1.0);
}

StageResult Penetration::result(const Ending& ending) const {
  StageResult out{.end = ending.end, .reason = ending.reason};
  const dem::World& w = bed_.world;
  double unbalanced = 0;
  for (const PenetrationSample& s : samples_) unbalanced += s.unbalanced / static_cast<double>(samples_.size());
  out.numerics = {
      {"time_step", w.dt, "s", {}, ""},
      {"steps", static_cast<double>(steps()), "1", {}, "steps of the stage"},
      {"normal_stiffness_used", w.law.normal_stiffness, "N/m", {}, "K_N after softening"},
      {"inertial_number", inertial_number_, "1", {}, "speed sqrt(rho/p), p the pressure at the final depth"},
      {"plate_speed", speed_, "m/s", {}, "downwards"},
      {"bed_height", surface_, "m", {}, "mean surface of the settled bed, where depth is zero"},
      {"unbalanced_force_ratio", unbalanced, "1", {}, "mean over the run"},
      {"deepest_overlap", guard_.deepest, "1", {}, "largest overlap over the smaller radius, at looks"},
      {"energy_gain", guard_.worst_gain, "1", {}, "largest excess of mechanical energy over the work put in"},
  };
  if (!samples_.empty()) out.curves.push_back(penetration_curve(samples_, plate_));
  if (ending.end == StageEnd::kCompleted) add_penetration_results(samples_, plate_, surface_, bed_.mean_diameter(), out);
  return out;
}

}  // namespace regolab::protocol
