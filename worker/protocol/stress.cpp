#include "worker/protocol/stress.h"

#include <algorithm>
#include <cmath>

#include "apparatus/apparatus.h"
#include "worker/dem/step.h"
#include "worker/dem/watch.h"
#include "worker/effects/breakage.h"
#include "worker/effects/contact.h"
#include "worker/effects/strengths.h"
#include "worker/protocol/surface.h"

namespace regolab::protocol {
namespace {

constexpr int kStepsPerLook = 250;
constexpr int kStepsPerRampTick = 20;
constexpr double kIsotropicTolerance = 0.03;  // of sigma3 [protocols, section 7]
constexpr double kApproachRate = 3e-2;        // inertial number of the walls' largest speed while no shear runs
constexpr double kRampTime = 8;               // in inertial times d sqrt(rho/p)
constexpr double kRampStrain = 0.02;          // of axial strain over which the plate gains its speed
constexpr double kLateralSpeed = 5;           // cap of the side walls, in axial strain rates
constexpr double kInterval = 0.0025;          // of axial strain between samples
constexpr double kLongestPhase = 100;         // of an isotropic phase, in the times that grains and dashpots take to come to rest
constexpr double kSteadyBalance = 0.05;       // unbalanced force ratio of a steady isotropic state

double geometric(double a, double b, double s) { return a * std::pow(b / a, s); }

}  // namespace

Stress::Stress(Bed bed, const StageSpec& spec)
    : bed_(std::move(bed)),
      sigma3_(spec.confining_stress),
      inertial_number_(effects::rate_factor(spec.effects) * spec.numerics.inertial_number),
      end_strain_(spec.numerics.axial_strain),
      servo_steps_(spec.numerics.isotropic_servo_steps) {
  start_law_ = bed_.world.law;
  const double kappa = spec.numerics.stress_stiffness_number;
  end_law_ = softened_law(bed_, kappa > 0 ? kappa * (sigma3_ + effects::attraction_pressure(bed_.effects)) * bed_.mean_diameter() : 0);
  end_law_.effects = effects::contact_effects(bed_.effects, {.pressure = effects::kStressMatch,
                                                             .mean_diameter = bed_.mean_diameter(),
                                                             .stiffness = end_law_.normal_stiffness,
                                                             .largest_load = effects::largest_stress_load(sigma3_)});
}

/// d sqrt(rho/p): the time in which grains rearrange under the present pressure [s].
double Stress::inertial_time() const { return bed_.mean_diameter() * std::sqrt(bed_.micro.grain_density / pressure_); }

void Stress::set_phase(Phase phase) {
  phase_ = phase;
  phase_start_ = bed_.world.time;
  looks_in_band_ = 0;
}

void Stress::enclose() {
  dem::World& w = bed_.world;
  start_step_ = w.step;
  start_pressure_ = pressure_ = bed_.pressure();
  w.gravity = 0;
  w.walls[dem::kTop] = {.present = true, .position = highest_point(bed_)};
  for (dem::Wall& wall : w.walls.wall) wall.friction = effects::wall_friction(bed_.effects);
  w.law.effects.wall_compliance = bed_.effects[EffectId::kBoundaryCompliance];
  dem::compute_forces(w);
  guard_.begin(w);
  set_phase(Phase::kApproach);
}

std::optional<Ending> Stress::advance() {
  if (!started_) {
    enclose();
    started_ = true;
  }
  return phase_ == Phase::kShear ? shear_look() : isotropic_look();
}

/// Stiffness and stress are raised together: stiffness alone would push the clusters apart by their stored overlaps.
void Stress::advance_ramp() {
  dem::World& w = bed_.world;
  ramp_ = std::min(1.0, ramp_ + kStepsPerRampTick * w.dt / (kRampTime * inertial_time()));
  pressure_ = geometric(start_pressure_, sigma3_, ramp_);
  const double before = dem::energies(w).total();
  const auto between = [&](double a, double b) { return a > 0 && b > 0 ? geometric(a, b, ramp_) : b; };
  w.law.normal_stiffness = between(start_law_.normal_stiffness, end_law_.normal_stiffness);
  w.law.tangential_stiffness = between(start_law_.tangential_stiffness, end_law_.tangential_stiffness);
  w.law.normal_damping = between(start_law_.normal_damping, end_law_.normal_damping);
  w.law.tangential_damping = between(start_law_.tangential_damping, end_law_.tangential_damping);
  w.law.effects.hertz_overlap = between(start_law_.effects.hertz_overlap, end_law_.effects.hertz_overlap);
  w.law.effects.hertz_most = std::max(start_law_.effects.hertz_most, end_law_.effects.hertz_most);
  guard_.excuse(before, dem::energies(w).total());
  renew_step(bed_);
}

bool Stress::window_within(double tolerance) const {
  for (const double sum : window_.stress) {
    if (std::abs(sum / window_.steps / pressure_ - 1) > tolerance) return false;
  }
  return true;
}

std::optional<Ending> Stress::isotropic_look() {
  dem::World& w = bed_.world;
  window_ = {};
  for (int i = 0; i < kStepsPerLook; ++i) {
    if (phase_ == Phase::kRamp && i % kStepsPerRampTick == 0) advance_ramp();
    for (int axis = 0; axis < 3; ++axis) {
      const double cap = kApproachRate / inertial_time() * 0.5 * opening(w.walls, axis);
      hold_stress({.wanted = pressure_, .most_speed = cap, .dashpot = bed_.wall_dashpot(), .time_steps = servo_steps_}, axis, servo_[static_cast<std::size_t>(axis)], w);
    }
    dem::step(w);
    for (int axis = 0; axis < 3; ++axis) window_.stress[axis] += mean_stress(w.walls, axis);
    ++window_.steps;
  }
  if (auto ending = guard_.look(bed_, bed_.micro.largest_diameter)) return ending;
  const bool in_band = window_within(phase_ == Phase::kApproach ? 0.1 : kIsotropicTolerance);
  const bool balanced = phase_ == Phase::kApproach || dem::unbalanced_force_ratio(w) < kSteadyBalance;
  looks_in_band_ = in_band && balanced ? looks_in_band_ + 1 : 0;
  if (phase_ == Phase::kApproach && looks_in_band_ >= 3) set_phase(Phase::kRamp);
  else if (phase_ == Phase::kRamp && ramp_ >= 1) set_phase(Phase::kHold);
  else if (phase_ == Phase::kHold && looks_in_band_ >= 3) start_shear();
  else if (w.time - phase_start_ > kLongestPhase * (inertial_time() + bed_.wall_dashpot() / w.law.normal_stiffness)) {
    return Ending{StageEnd::kNotSettled, "the three wall stresses did not come within 3 % of " + std::to_string(sigma3_) +
                                             " Pa (the specimen keeps yielding) raise the friction or the damping"};
  }
  return std::nullopt;
}

void Stress::start_shear() {
  set_phase(Phase::kShear);
  dem::World& w = bed_.world;
  shear_start_time_ = w.time;
  height0_ = opening(w.walls, 2);
  volume0_ = height0_ * area_across(w.walls, 2);
  void_ratio0_ = volume0_ / (effects::density_ratio(bed_.effects) * bed_.solid_volume) - 1;
  w.walls[dem::kFloor].velocity = 0;
  interval_ = {};
  interval_steps_ = 0;
  StressSample first;
  first.top = w.walls[dem::kTop].force / area_across(w.walls, 2);
  first.bottom = w.walls[dem::kFloor].force / area_across(w.walls, 2);
  first.lateral_x = mean_stress(w.walls, 0);
  first.lateral_y = mean_stress(w.walls, 1);
  samples_ = {first};
}

/// The side walls' error: from nothing to p_0 as the plate gains its speed [Pa].
double Stress::lateral_offset() const {
  const double rate = inertial_number_ / inertial_time();
  const double gained = (bed_.world.time - shear_start_time_ + bed_.world.dt) * rate / (2 * kRampStrain);
  return bed_.effects[EffectId::kLateralStressOffset] * std::min(1.0, gained);
}

double Stress::axial_strain() const { return 1 - opening(bed_.world.walls, 2) / height0_; }

void Stress::shear_step() {
  dem::World& w = bed_.world;
  const double rate = inertial_number_ / inertial_time();
  const double gained = (w.time - shear_start_time_ + w.dt) * rate / (2 * kRampStrain);  // 2 % strain at the end of the ramp
  w.walls[dem::kTop].velocity = -rate * height0_ * std::min(1.0, gained);
  const double offset = lateral_offset();
  for (int axis = 0; axis < 2; ++axis) {
    const Servo servo{.wanted = sigma3_ + offset, .most_speed = kLateralSpeed * rate * opening(w.walls, axis), .dashpot = bed_.wall_dashpot(),
                      .time_steps = effects::servo_steps(bed_.effects, Servo{}.time_steps)};
    hold_stress(servo, axis, servo_[static_cast<std::size_t>(axis)], w);
  }
  dem::step(w);
  const double area = area_across(w.walls, 2);
  interval_.top += w.walls[dem::kTop].force / area;
  interval_.bottom += w.walls[dem::kFloor].force / area;
  interval_.lateral_x += mean_stress(w.walls, 0) - offset;  // what the controller believes
  interval_.lateral_y += mean_stress(w.walls, 1) - offset;
  ++interval_steps_;
}

void Stress::close_interval(double strain) {
  const dem::World& w = bed_.world;
  StressSample mean = interval_;
  for (double* sum : {&mean.top, &mean.bottom, &mean.lateral_x, &mean.lateral_y}) *sum /= interval_steps_;
  mean.strain = strain;
  mean.volumetric_strain = 1 - opening(w.walls, 2) * area_across(w.walls, 2) / volume0_;
  mean.unbalanced = dem::unbalanced_force_ratio(w);
  samples_.push_back(mean);
  interval_ = {};
  interval_steps_ = 0;
}

std::optional<Ending> Stress::shear_look() {
  for (int i = 0; i < kStepsPerLook; ++i) {
    shear_step();
    const double strain = axial_strain();
    if (strain >= kInterval * static_cast<double>(samples_.size())) close_interval(strain);
    if (strain >= end_strain_) return Ending{};
  }
  if (auto ending = guard_.look(bed_, bed_.micro.largest_diameter)) return ending;
  if (bed_.effects[EffectId::kBreakage] != 0) break_overloaded();
  return std::nullopt;
}

void Stress::break_overloaded() {
  dem::World& w = bed_.world;
  const std::vector<int> clusters = effects::overloaded(w, effects::bond_strength(bed_.effects));
  if (clusters.empty()) return;
  const double before = dem::energies(w).total();
  effects::break_clusters(clusters, w);
  broken_ += static_cast<int>(clusters.size());
  renew_step(bed_);
  dem::compute_forces(w);
  guard_.excuse(before, dem::energies(w).total());
}

std::string_view Stress::phase() const { return phase_ == Phase::kShear ? "shear" : "isotropic"; }

double Stress::fraction() const {
  switch (phase_) {
    case Phase::kApproach: return 0.05;
    case Phase::kRamp: return 0.1 + 0.15 * ramp_;
    case Phase::kHold: return 0.3;
    case Phase::kShear: return 0.35 + 0.65 * std::min(1.0, axial_strain() / end_strain_);
  }
  return 0;
}

StageResult Stress::result(const Ending& ending) const {
  StageResult out{.end = ending.end, .reason = ending.reason};
  const dem::World& w = bed_.world;
  double lateral_error = 0, unbalanced = 0;
  for (const StressSample& s : samples_) {
    lateral_error += std::abs(s.sigma3() / sigma3_ - 1) / static_cast<double>(samples_.size());
    unbalanced += s.unbalanced / static_cast<double>(samples_.size());
  }
  out.numerics = {
      {"time_step", w.dt, "s", {}, ""},
      {"steps", static_cast<double>(w.step - start_step_), "1", {}, "steps of the stage"},
      {"normal_stiffness_used", w.law.normal_stiffness, "N/m", {}, "K_N after softening"},
      {"stiffness_number", w.law.normal_stiffness / (sigma3_ * bed_.mean_diameter()), "1", {}, "K/(sigma3 d)"},
      {"inertial_number", inertial_number_, "1", {}, "rate d sqrt(rho/sigma3) of the axial strain"},
      {"strain_rate", inertial_number_ / (bed_.mean_diameter() * std::sqrt(bed_.micro.grain_density / sigma3_)), "1/s", {}, "axial"},
      {"lateral_stress_error", lateral_error, "1", {}, "mean of |measured / wanted - 1| over the shear"},
      {"unbalanced_force_ratio", unbalanced, "1", {}, "mean over the shear"},
      {"deepest_overlap", guard_.deepest, "1", {}, "largest overlap over the smaller radius, at looks"},
      {"energy_gain", guard_.worst_gain, "1", {}, "largest excess of mechanical energy over the work put in"},
  };
  if (bed_.effects[EffectId::kBreakage] != 0) {
    out.numerics.push_back({"clusters_broken", static_cast<double>(broken_), "1", {}, "by contacts beyond the strength of their bonds"});
  }
  const auto measured = as_measured(samples_, apparatus_of(bed_.effects));
  if (ending.end == StageEnd::kCompleted) add_stress_results(measured, sigma3_, end_strain_, void_ratio0_, out);
  return out;
}

}  // namespace regolab::protocol
