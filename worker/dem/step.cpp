#include "worker/dem/step.h"

#include <cmath>

#include "worker/dem/integrate.h"

namespace regolab::dem {
namespace {

/// True once a grain may have moved half the skin since the lists were built, or a wall has.
bool lists_outdated(const World& w) {
  const double half = 0.5 * w.skin;
  if (w.lists_stale || moved_beyond(half, w.at_build, w.bodies)) return true;
  for (int id = 0; id < kWalls; ++id) {
    if (std::abs(w.walls[id].position - w.walls.position_at_build[static_cast<std::size_t>(id)]) > half) return true;
  }
  return false;
}

/// gather, compute; each thread its own stretch. The stretches do not show in the results.
template <class Gather>
void find_and_compute(World& w, std::size_t listed, Contacts& contacts, Gather gather) {
  cut_segments(listed, w.threads, contacts);
#pragma omp parallel for num_threads(w.threads) schedule(static, 1) if (w.threads > 1)
  for (int t = 0; t < w.threads; ++t) {
    Contacts::Segment& segment = contacts.segments[static_cast<std::size_t>(t)];
    gather(segment);
    apply_law(w.law, w.dt, contacts, segment);
  }
}

void contact_forces(World& w) {
  clear_forces(w.bodies);
  find_and_compute(w, w.pairs.a.size(), w.contacts,
                   [&](auto& segment) { gather_pairs(w.bodies, w.spheres, w.pairs, w.law, w.step, w.contacts, segment); });
  find_and_compute(w, w.walls.sphere.size(), w.wall_contacts,
                   [&](auto& segment) { gather_walls(w.bodies, w.spheres, w.walls, w.law, w.step, w.wall_contacts, segment); });
  store_history(w.contacts, w.step, w.pairs.history);
  store_history(w.wall_contacts, w.step, w.walls.history);
  scatter_pairs(w.contacts, w.bodies);
  scatter_walls(w.wall_contacts, w.bodies, w.walls);
}

}  // namespace

void rebuild_lists(World& w) {
  build_pairs(w.bodies, w.spheres, w.skin, w.step, w.grid, w.pairs);
  build_wall_list(w.bodies, w.spheres, w.skin, w.step, w.walls);
  w.at_build = poses_of(w.bodies);
  w.lists_stale = false;
  ++w.list_builds;
}

void compute_forces(World& w) {
  place_spheres(w.bodies, w.spheres);
  rebuild_lists(w);
  contact_forces(w);
}

void step(World& w) {
  ++w.step;
  w.time += w.dt;
  for (int id = 0; id < kWalls; ++id) w.wall_work += w.walls[id].force * inward(id) * w.walls[id].velocity * w.dt;
  kick_and_drift(w.gravity, w.drag, w.dt, w.bodies);
  move_walls(w.walls, w.dt);
  place_spheres(w.bodies, w.spheres);
  if (lists_outdated(w)) rebuild_lists(w);
  contact_forces(w);
}

}  // namespace regolab::dem
