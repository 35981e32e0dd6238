#include "worker/protocol/settle.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/step.h"
#include "worker/dem/watch.h"
#include "worker/effects/strengths.h"
#include "worker/generate/random.h"
#include "worker/protocol/surface.h"

namespace regolab::protocol {
namespace {

constexpr int kStepsPerLook = 500;
constexpr int kStepsPerRecord = 100;
constexpr double kRestEnergy = 2e-3;        // mean kinetic energy over m g d / 2 [protocols, section 4]
constexpr double kFloorTolerance = 0.05;    // of the weight
constexpr double kQuenchedEnergy = 1e-7;
constexpr int kQuenchLooks = 40;            // at most; a frictionless bed may creep for ever
constexpr double kLongestFall = 40;         // in fall times of the filling box

}  // namespace

Settle::Settle(Bed bed, const StageSpec& spec) : bed_(std::move(bed)), stiffness_number_(spec.numerics.settle_stiffness_number) {
  const generate::Random random(spec.seed);
  witness_ = static_cast<int>(random.uniform(generate::Purpose::kWitness, 0) * bed_.world.bodies.count());
  if (bed_.world.bodies.count() > 0) {
    fall_time_ = std::sqrt(2 * highest_point(bed_) / bed_.world.gravity);
    time_limit_ = kLongestFall * fall_time_;
  }
}

void Settle::note() {
  const dem::World& w = bed_.world;
  const dem::Vec3 force = dem::contact_force_on(w, witness_);
  record_.push_back({w.time, dem::energies(w).kinetic, w.walls[dem::kFloor].force, dem::unbalanced_force_ratio(w), force[0],
                     force[1], force[2]});
}

/// Vertical force on the grains: of the floor, and of side walls that rub.
double Settle::carried() const {
  const dem::World& w = bed_.world;
  if (!(effects::wall_friction(bed_.effects) > 0)) return w.walls[dem::kFloor].force;
  double sum = 0;
  for (const dem::Load& load : w.bodies.load) sum += load.fz;
  return sum;
}

bool Settle::at_rest() const {
  const dem::World& w = bed_.world;
  const double floor = carried() / dem::weight(w, w.gravity);
  return dem::relative_kinetic_energy(w, w.gravity, bed_.mean_diameter()) < kRestEnergy &&
         std::abs(floor - 1) < kFloorTolerance;
}

std::optional<Ending> Settle::advance() {
  if (!started_) {
    dem::compute_forces(bed_.world);
    guard_.begin(bed_.world);
    started_ = true;
  }
  for (int i = 0; i < kStepsPerLook; ++i) {
    dem::step(bed_.world);
    if ((i + 1) % kStepsPerRecord == 0) note();
  }
  if (auto ending = guard_.look(bed_, bed_.micro.largest_diameter)) return ending;
  return quenching_ ? quench() : fall();
}

std::optional<Ending> Settle::fall() {
  looks_at_rest_ = at_rest() ? looks_at_rest_ + 1 : 0;
  if (looks_at_rest_ >= 3) {
    quenching_ = true;
    end_preparation();
    bed_.world.drag = 2.0 * std::sqrt(bed_.micro.gravity / bed_.mean_diameter());
  } else if (bed_.world.time > time_limit_) {
    const double energy = dem::relative_kinetic_energy(bed_.world, bed_.micro.gravity, bed_.mean_diameter());
    return Ending{StageEnd::kNotSettled, "the bed did not come to rest in " + std::to_string(time_limit_) +
                                             " s (kinetic energy " + std::to_string(energy) +
                                             " m g d/2, limit 0.002) raise the damping or the friction"};
  }
  return std::nullopt;
}

/// From here on the bed lies under its own gravity and rubs as its grains do.
void Settle::end_preparation() {
  const bool heavier = bed_.effects[EffectId::kPreparationGravity] != 0;
  if (!heavier && bed_.effects[EffectId::kPreparationFriction] == 0) return;
  dem::World& w = bed_.world;
  const double before = dem::energies(w).total();
  w.gravity = bed_.micro.gravity;
  w.law = settling_law(bed_, stiffness_number_, 1);
  w.walls[dem::kFloor].friction = w.law.friction;
  renew_step(bed_);
  guard_.excuse(before, dem::energies(w).total());
}

std::optional<Ending> Settle::quench() {
  dem::World& w = bed_.world;
  ++quench_looks_;
  const bool quiet = dem::relative_kinetic_energy(w, w.gravity, bed_.mean_diameter()) < kQuenchedEnergy;
  if (!quiet && quench_looks_ < kQuenchLooks) return std::nullopt;
  w.drag = 0;
  dem::Bodies& b = w.bodies;
  for (auto* motion : {&b.vx, &b.vy, &b.vz, &b.lx, &b.ly, &b.lz, &b.wx, &b.wy, &b.wz}) {
    std::fill(motion->begin(), motion->end(), 0.0);
  }
  return Ending{};
}

double Settle::fraction() const {
  if (quenching_) return 0.8 + 0.2 * std::min(1.0, quench_looks_ / 10.0);
  return 0.8 * std::min(1.0, bed_.world.time / (4 * fall_time_));
}

StageResult Settle::result(const Ending& ending) const {
  const dem::World& w = bed_.world;
  StageResult out{.end = ending.end, .reason = ending.reason};
  out.numerics = {
      {"time_step", w.dt, "s", {}, "time step at the end of the stage"},
      {"steps", static_cast<double>(w.step), "1", {}, "steps of the stage"},
      {"simulated_time", w.time, "s", {}, "time simulated"},
      {"normal_stiffness_used", w.law.normal_stiffness, "N/m", {}, "K_N after softening"},
      {"stiffness_factor", w.law.normal_stiffness / bed_.micro.normal_stiffness, "1", {}, "softening factor"},
      {"floor_force_over_weight", w.walls[dem::kFloor].force / dem::weight(w, w.gravity), "1", {}, "at the end"},
      {"unbalanced_force_ratio", dem::unbalanced_force_ratio(w), "1", {}, "at the end"},
      {"relative_kinetic_energy", record_.empty() ? 0 : record_.back().kinetic / (0.5 * dem::weight(w, w.gravity) * bed_.mean_diameter()),
       "1", {}, "mean kinetic energy over m g d / 2 before the last motion was taken out"},
      {"deepest_overlap", guard_.deepest, "1", {}, "largest overlap over the smaller radius, at looks"},
      {"final_overlap", dem::deepest_overlap(w), "1", {}, "largest overlap over the smaller radius at the end"},
      {"energy_gain", guard_.worst_gain, "1", {}, "largest excess of mechanical energy over the work put in"},
  };
  const auto curve = [&](const char* id, const char* name, const char* unit, auto value) {
    Curve c{id, "settle", "time", "s", name, unit, {}, {}};
    for (const Record& r : record_) {
      c.x.push_back(r.time);
      c.y.push_back(value(r));
    }
    out.curves.push_back(std::move(c));
  };
  curve("settle_kinetic_energy", "kinetic_energy", "J", [](const Record& r) { return r.kinetic; });
  curve("settle_floor_force", "floor_force", "N", [](const Record& r) { return r.floor_force; });
  curve("settle_unbalanced_force_ratio", "unbalanced_force_ratio", "1", [](const Record& r) { return r.unbalanced; });
  curve("settle_particle_force_x", "force_x", "N", [](const Record& r) { return r.witness_x; });
  curve("settle_particle_force_y", "force_y", "N", [](const Record& r) { return r.witness_y; });
  curve("settle_particle_force_z", "force_z", "N", [](const Record& r) { return r.witness_z; });
  return out;
}

}  // namespace regolab::protocol
