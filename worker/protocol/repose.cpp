#include "worker/protocol/repose.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "worker/dem/step.h"
#include "worker/dem/watch.h"
#include "worker/protocol/surface.h"

namespace regolab::protocol {
namespace {

constexpr int kColumns = 24, kStrips = 16;
constexpr int kStepsPerLook = 500;
constexpr double kFixedBelow = 0.35;      // of L_S
constexpr double kTrayDepth = 4;          // of L_S
constexpr double kRestEnergy = 2e-4;      // tighter than settling's: a creeping slope is not at rest
constexpr double kShortestTime = 3;       // in fall times of the bed height, before rest is believed
constexpr double kLongestTime = 120;
constexpr double kSwingTime = 10;         // in fall times: what moves then in a cohesive bed swings on threads of attraction, for ever
constexpr double kStoodShare = 0.6;       // of the back wall's height kept at the edge: no slope formed

/// Slope of the least-squares line through the points; falling to the right is positive.
double falling_slope(const std::vector<double>& x, const std::vector<double>& h) {
  const auto n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n, mh = std::accumulate(h.begin(), h.end(), 0.0) / n;
  double sxx = 0, sxh = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxh += (x[i] - mx) * (h[i] - mh);
  }
  return sxx > 0 ? -sxh / sxx : 0;
}

struct Profile {
  std::vector<double> x, h;               // [kColumns] column centre, mean over strips
  std::vector<std::vector<double>> strip; // [kStrips][kColumns]
};

Profile profile_of(const Bed& bed) {
  const auto heights = surface_heights(bed, kColumns, kStrips);
  Profile p;
  p.h.assign(kColumns, 0.0);
  for (int i = 0; i < kColumns; ++i) p.x.push_back((i + 0.5) * bed.length / kColumns);
  for (int j = 0; j < kStrips; ++j) {
    const auto from = heights.begin() + j * kColumns;
    p.strip.emplace_back(from, from + kColumns);
    for (std::size_t i = 0; i < kColumns; ++i) p.h[i] += p.strip.back()[i] / kStrips;
  }
  return p;
}

/// Strips share grains with their neighbours, so this is a lower bound of the true standard error of the angle.
double strip_standard_error(const Profile& p) {
  std::vector<double> angles;
  for (const auto& strip : p.strip) angles.push_back(std::atan(falling_slope(p.x, strip)));
  const double mean = std::accumulate(angles.begin(), angles.end(), 0.0) / kStrips;
  double squares = 0;
  for (const double a : angles) squares += (a - mean) * (a - mean);
  return std::sqrt(squares / (kStrips - 1) / kStrips);
}

}  // namespace

SlopeReading read_slope(const std::vector<double>& x, const std::vector<double>& h, double length) {
  SlopeReading r;
  const auto crest = static_cast<std::size_t>(std::max_element(h.begin(), h.end()) - h.begin());
  const double low = *std::min_element(h.begin(), h.end()), range = h[crest] - low;
  std::vector<double> sx, sh;
  for (std::size_t i = crest; i < h.size(); ++i) {
    if (h[i] < low + 0.1 * range || h[i] > low + 0.9 * range) continue;
    sx.push_back(x[i]);
    sh.push_back(h[i]);
  }
  r.has_sloping_part = sx.size() >= 3;
  if (r.has_sloping_part) r.sloping_part = std::atan(falling_slope(sx, sh));
  r.whole = std::atan(falling_slope(x, h));
  if (crest + 1 < h.size()) r.chord = std::atan((h[crest] - h.back()) / (x.back() - x[crest]));
  r.wedge = std::atan(2 * std::accumulate(h.begin(), h.end(), 0.0) / static_cast<double>(h.size()) / length);
  return r;
}

Repose::Repose(Bed bed) : bed_(std::move(bed)) {}

void Repose::open_the_box() {
  dem::World& w = bed_.world;
  start_time_ = w.time;
  start_step_ = w.step;
  height_before_ = mean_height(bed_);
  time_limit_ = kLongestTime * std::sqrt(2 * height_before_ / w.gravity);
  for (int i = 0; i < w.bodies.count(); ++i) {
    if (w.bodies.z[static_cast<std::size_t>(i)] < kFixedBelow * bed_.micro.largest_diameter) w.bodies.hold_fixed(i);
  }
  w.walls[dem::kRight].present = false;
  w.walls.floor_end = bed_.length;
  dem::compute_forces(w);
  guard_.begin(w);
}

void Repose::empty_the_tray() {
  dem::World& w = bed_.world;
  const double before = dem::energies(w).total();
  bool any = false;
  for (int i = 0; i < w.bodies.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (w.bodies.gone[k] || w.bodies.z[k] > -kTrayDepth * bed_.micro.largest_diameter) continue;
    w.bodies.gone[k] = 1;
    w.bodies.hold_fixed(i);
    any = true;
  }
  if (!any) return;
  w.lists_stale = true;
  guard_.excuse(before, dem::energies(w).total());
}

std::optional<Ending> Repose::advance() {
  if (!started_) {
    open_the_box();
    started_ = true;
  }
  dem::World& w = bed_.world;
  for (int i = 0; i < kStepsPerLook; ++i) dem::step(w);
  if (auto ending = guard_.look(bed_, bed_.micro.largest_diameter)) return ending;
  empty_the_tray();
  const double elapsed = w.time - start_time_, fall_time = std::sqrt(2 * height_before_ / w.gravity);
  const double energy = dem::relative_kinetic_energy(w, w.gravity, bed_.mean_diameter());
  if (w.law.effects.cohesion > 0 && elapsed > kSwingTime * fall_time) w.drag = 0.5 / fall_time;
  looks_at_rest_ = elapsed > kShortestTime * fall_time && energy < kRestEnergy ? looks_at_rest_ + 1 : 0;
  if (looks_at_rest_ >= 3) return Ending{};
  if (elapsed > time_limit_) {
    return Ending{StageEnd::kNotSettled, "the slope did not come to rest in " + std::to_string(elapsed) + " s (kinetic energy " +
                                             std::to_string(energy) + " m g d/2, limit 0.0002) raise the damping or the friction"};
  }
  return std::nullopt;
}

double Repose::fraction() const {
  if (!started_) return 0;
  const double usual = 8 * std::sqrt(2 * height_before_ / bed_.micro.gravity);
  return std::min(0.95, (bed_.world.time - start_time_) / usual);
}

StageResult Repose::result(const Ending& ending) const {
  StageResult out{.end = ending.end, .reason = ending.reason};
  const dem::World& w = bed_.world;
  const auto& gone = w.bodies.gone;
  out.numerics = {
      {"time_step", w.dt, "s", {}, ""},
      {"steps", static_cast<double>(w.step - start_step_), "1", {}, "steps of the stage"},
      {"simulated_time", w.time - start_time_, "s", {}, "time simulated"},
      {"normal_stiffness_used", w.law.normal_stiffness, "N/m", {}, "K_N after softening"},
      {"clusters_left", static_cast<double>(std::count(gone.begin(), gone.end(), 0)), "1", {}, "clusters not in the tray"},
      {"relative_kinetic_energy", dem::relative_kinetic_energy(w, w.gravity, bed_.mean_diameter()), "1", {}, "at the end"},
      {"deepest_overlap", guard_.deepest, "1", {}, "largest overlap over the smaller radius, at looks"},
      {"energy_gain", guard_.worst_gain, "1", {}, "largest excess of mechanical energy over the work put in"},
  };
  if (ending.end != StageEnd::kCompleted) return out;

  const Profile p = profile_of(bed_);
  const SlopeReading r = read_slope(p.x, p.h, bed_.length);
  const bool stood = 0.5 * (p.h[kColumns - 2] + p.h[kColumns - 1]) > kStoodShare * 0.5 * (p.h[0] + p.h[1]);
  out.measurements = {
      {"repose_column_stood", stood ? 1.0 : 0.0, "1", {},
       "1 when the surface at the open edge kept more than 0.6 of the height at the back wall, so that no slope formed"},
      {"repose_angle_whole", r.whole, "rad", strip_standard_error(p), "straight line through the whole surface, wall to edge"},
      {"repose_angle_chord", r.chord, "rad", {}, "from the crest to the edge"},
      {"repose_angle_wedge", r.wedge, "rad", {}, "atan(2 mean(h)/L)"},
      {"repose_limit", std::atan(height_before_ / bed_.length), "rad", {},
       "atan(height before the wall was removed / L): near it the box was too short to show the angle"},
  };
  if (!stood && r.has_sloping_part) {
    out.measurements.push_back({"repose_angle", r.sloping_part, "rad", strip_standard_error(p),
                                "straight line through the sloping part of the surface (10 to 90 % of its range, right of the "
                                "crest) after the right wall was removed"});
  }
  out.curves.push_back({"repose_profile", "repose", "distance_from_left_wall", "m", "surface_height", "m", p.x, p.h});
  return out;
}

}  // namespace regolab::protocol
