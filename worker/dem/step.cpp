#include "worker/dem/step.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "worker/dem/integrate.h"
#include "worker/dem/simd/pack.h"
#include "worker/dem/team.h"

namespace regolab::dem {
namespace {

/// Runs visit(t, threads) for each thread t.
template <class Visit>
void each_thread(const World& w, Visit visit) {
  if (w.threads <= 1) return visit(std::size_t{0}, std::size_t{1});
  const auto threads = static_cast<std::size_t>(w.threads);
  my_team(w.threads).run([&](int t) { visit(static_cast<std::size_t>(t), threads); });
}

/// Runs visit(stretch, thread) over [0, n), each thread its own slabs. Cuts lie at multiples of kMostLanes and do not show in the results.
template <class Visit>
void share_out(const World& w, std::size_t n, Visit visit) {
  each_thread(w, [&](std::size_t t, std::size_t threads) {
    visit(Stretch{cut(n, kSlabs * t / threads, kSlabs), cut(n, kSlabs * (t + 1) / threads, kSlabs)}, t);
  });
}

std::size_t slabs_of(const World& w) {
  if (w.slabs != 0) return w.slabs;
  return w.bodies.count() > kMostInOneSlab ? kSlabs : 1;
}

/// The same over what the slabs of the bed begin at: each thread the slabs of its clusters.
template <class Visit>
void share_slabs(const World& w, const std::array<std::size_t, kSlabs + 1>& begin, Visit visit) {
  const std::size_t slabs = slabs_of(w);
  if (slabs == 1) return visit(Stretch{begin[0], begin[1]});
  each_thread(w, [&](std::size_t t, std::size_t threads) { visit(Stretch{begin[slabs * t / threads], begin[slabs * (t + 1) / threads]}); });
}

LoadTarget target_of(World& w) { return {w.bodies.load.data(), w.crossings.cell.data()}; }
ForceInput input_of(const World& w) { return {w.law, w.dt, w.balls, w.bodies}; }

void renew_margins(World& w) {
  const Travel travel{.time = w.near_lists.steps * w.dt, .least = 5e-4 * w.skin, .most = w.skin};
  allow(w.bodies, travel, w.margins.margin);
  w.margins.path.assign(w.bodies.x.size(), 0.0);
  w.margins.anything_swings = std::any_of(w.bodies.swing.begin(), w.bodies.swing.end(), [](double swing) { return swing > 0; });
  double fastest = 0;
  for (std::size_t id = 0; id < kWallIds; ++id) {
    w.walls_at_refresh[id] = w.walls.wall[id].position;
    fastest = std::max(fastest, std::abs(w.walls.wall[id].velocity));
  }
  w.wall_margin = std::clamp(2 * travel.time * fastest, travel.least, travel.most);
}

/// Farthest gap over which two of the spheres may attract one another [m].
double attraction_range(const World& w) {
  if (!(w.law.effects.cohesion > 0) || w.spheres.radius.empty()) return 0;
  return kAttractionRange * 2 * *std::max_element(w.spheres.radius.begin(), w.spheres.radius.end());
}

// Work, in units of pressing one slot (about 10 ns), measured on the beds of tests/bench.
constexpr double kPerListedPair = 0.5, kPerSphere = 0.5, kPerCluster = 2;  // of a refresh
constexpr double kSearchPerCluster = 60;                                   // of a new pair list

/// Allowances of at least twice the margins: else the list would be stale when made.
void list_pairs(World& w) {
  const auto refreshes = static_cast<double>(w.refreshes - w.refreshes_at_build);
  const double life = static_cast<double>(std::max<std::int64_t>(1, w.step - w.pair_lists.made_at));
  w.pair_lists.renew(w.step, kPerListedPair * static_cast<double>(w.pairs.a.size()) * refreshes / life,
                     kSearchPerCluster * static_cast<double>(w.bodies.x.size()));
  w.refreshes_at_build = w.refreshes;
  const double time = w.pair_lists.steps * w.dt;
  allow(w.bodies, {.time = time, .least = 0.1 * w.skin, .most = 4 * w.skin}, w.pairs.allowance);
  for (std::size_t i = 0; i < w.pairs.allowance.size(); ++i) {
    w.pairs.allowance[i] = std::max(w.pairs.allowance[i], 2 * w.margins.margin[i]);
  }
  build_pairs(w.bodies, w.spheres, w.centres, time, w.pairs);
  w.lists_stale = false;
  ++w.list_builds;
}

void list_near_pairs(World& w) {
  make_room_for_pairs(w.pairs.a.size(), w.near_pairs);
  struct Found {
    std::size_t from = 0, count = 0;
  };
  std::vector<Found> found(static_cast<std::size_t>(w.threads));  // [threads] in the order of the list
  share_out(w, w.pairs.a.size(), [&](Stretch s, std::size_t part) {
    found[part] = {s.begin, list_near_pairs(w.pairs, w.spheres, w.centres, w.margins, s, w.near_pairs)};
  });
  w.near_pairs.count = 0;
  for (const Found& part : found) append_pairs(part.from, part.count, w.near_pairs);
}

}  // namespace

bool kick_and_drift(World& w) {
  const Kick kick{w.gravity, w.drag > 0.0 ? std::max(0.0, 1.0 - w.drag * w.dt) : 1.0, w.dt};
  std::atomic<bool> left = false;
  share_out(w, w.bodies.x.size(), [&](Stretch s, std::size_t) {
    if (kick_and_drift(kick, s, w.bodies, w.margins)) left.store(true, std::memory_order_relaxed);
  });
  return move_walls(w.dt, w.wall_margin, w.walls_at_refresh, w.walls) || left;
}

void refresh_lists(World& w) {
  w.hold_springs();
  w.near_lists.renew(w.step, static_cast<double>(w.near_pairs.count + w.near_walls.count),
                     kPerListedPair * static_cast<double>(w.pairs.a.size()) + kPerSphere * static_cast<double>(w.spheres.count()) +
                         kPerCluster * static_cast<double>(w.bodies.x.size()));
  w.near_pairs.rolls = w.near_walls.rolls = w.law.effects.rolling > 0;
  w.pairs.attraction = w.margins.attraction = attraction_range(w);
  renew_margins(w);
  w.centres.resize(static_cast<std::size_t>(w.spheres.count()));
  share_out(w, w.bodies.x.size(), [&](Stretch s, std::size_t) { sphere_centres(w.bodies, w.spheres, s, w.centres); });
  if (w.lists_stale || moved_beyond(w.pairs, w.bodies, w.margins)) list_pairs(w);
  list_near_pairs(w);
  list_near_walls(w.bodies, w.spheres, w.centres, w.walls, w.margins, w.wall_margin, w.near_walls);
  fill_pair_slots(w.bodies, w.near_pairs);
  fill_wall_slots(w.bodies, w.near_walls);
  give_springs(w.pair_springs, w.near_pairs);
  give_springs(w.wall_springs, w.near_walls);
  collect_balls(w.spheres, w.near_pairs, w.near_walls, w.balls);
  list_crossings(w.bodies.x.size(), slabs_of(w), w.near_walls, w.near_pairs, w.crossings);
  ++w.refreshes;
}

void place_balls(World& w) {
  share_out(w, w.balls.body.size(), [&](Stretch s, std::size_t) { place_balls(w.bodies, s, w.balls); });
}

void press_pairs(World& w) {
  share_slabs(w, w.crossings.pairs, [&](Stretch s) { press_pairs(input_of(w), s, w.near_pairs, target_of(w)); });
}

void press_walls(World& w) {
  share_slabs(w, w.crossings.walls, [&](Stretch s) { press_walls(input_of(w), w.walls, s, w.near_walls, target_of(w)); });
  sum_wall_forces(w.near_walls, w.walls);
}

void add_crossings(World& w) {
  if (w.crossings.cell.empty()) return;
  share_slabs(w, w.crossings.begin, [&](Stretch s) { add_crossings(s, w.crossings, w.bodies.load.data()); });
}

void compute_forces(World& w) {
  publish_motion(w.bodies);
  std::fill(w.bodies.load.begin(), w.bodies.load.end(), Load{});
  w.lists_stale = true;
  refresh_lists(w);
  place_balls(w);
  press_pairs(w);
  press_walls(w);
  add_crossings(w);
}

void step(World& w) {
  ++w.step;
  w.time += w.dt;
  const double power_before = wall_power(w.walls);
  if (w.lists_stale) renew_margins(w);
  const bool strayed = kick_and_drift(w);
  if (strayed || w.lists_stale) refresh_lists(w);
  place_balls(w);
  press_pairs(w);
  press_walls(w);
  add_crossings(w);
  w.wall_work += 0.5 * (power_before + wall_power(w.walls)) * w.dt;
}

}  // namespace regolab::dem
