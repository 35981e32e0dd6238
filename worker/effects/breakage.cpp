#include "worker/effects/breakage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "worker/dem/contacts.h"

namespace regolab::effects {
namespace {

using dem::Bodies;

/// Body j of the new numbering: body `from` as it is, or its sphere `sphere` alone.
struct Origin {
  std::size_t from;
  std::int32_t sphere;  ///< -1: the whole
};

std::vector<Origin> origins(const Bodies& b, const std::vector<int>& broken) {
  std::vector<Origin> out;
  auto next = broken.begin();
  for (int i = 0; i < b.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (next == broken.end() || *next != i) {
      out.push_back({k, -1});
      continue;
    }
    ++next;
    for (auto s = b.first_sphere[k]; s < b.first_sphere[k + 1]; ++s) out.push_back({k, s});
  }
  return out;
}

template <class T>
void take(const std::vector<Origin>& origins, std::vector<T>& field) {
  std::vector<T> taken;
  taken.reserve(origins.size());
  for (const Origin& o : origins) taken.push_back(field[o.from]);
  field = std::move(taken);
}

/// Body j becomes the sphere at `at`, still with the cluster's velocities and spin.
void make_single(Bodies& b, std::size_t j, const dem::Vec3& at, double radius) {
  const dem::Vec3 arm{at[0] - b.x[j], at[1] - b.y[j], at[2] - b.z[j]};
  const dem::Vec3 v = dem::point_velocity(b, j, arm[0], arm[1], arm[2]);
  b.x[j] = at[0], b.y[j] = at[1], b.z[j] = at[2];
  b.vx[j] = v[0], b.vy[j] = v[1], b.vz[j] = v[2];
  const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  b.mass[j] *= volume / b.solid_volume[j];
  b.solid_volume[j] = volume;
  const double inertia = 0.4 * b.mass[j] * radius * radius;
  b.inverse_mass[j] = 1 / b.mass[j];
  b.inverse_ix[j] = b.inverse_iy[j] = b.inverse_iz[j] = 1 / inertia;
  b.lx[j] = inertia * b.wx[j], b.ly[j] = inertia * b.wy[j], b.lz[j] = inertia * b.wz[j];
  b.qw[j] = 1, b.qx[j] = b.qy[j] = b.qz[j] = 0;
  b.parent_diameter[j] = 2 * radius;
  b.reach[j] = radius;
  b.swing[j] = 0;
}

}  // namespace

std::vector<int> overloaded(const dem::World& w, double strength) {
  std::vector<int> clusters;
  const auto look = [&](std::int32_t sphere, std::int32_t body, double force) {
    const auto i = static_cast<std::size_t>(body);
    const double d = 2 * w.spheres.radius[static_cast<std::size_t>(sphere)];
    const bool bonded = w.bodies.first_sphere[i + 1] - w.bodies.first_sphere[i] > 1 && !w.bodies.is_fixed(body);
    if (bonded && force > strength * d * d) clusters.push_back(body);
  };
  for (const auto& touching : {dem::contacts(w), dem::wall_contacts(w)}) {
    for (const dem::Contact& c : touching) {
      const double force = std::hypot(c.force[0], c.force[1], c.force[2]);
      look(c.sphere_a, c.body_a, force);
      if (c.sphere_b >= 0) look(c.sphere_b, c.body_b, force);
    }
  }
  std::ranges::sort(clusters);
  clusters.erase(std::ranges::unique(clusters).begin(), clusters.end());
  return clusters;
}

void break_clusters(const std::vector<int>& clusters, dem::World& w) {
  if (clusters.empty()) return;
  w.hold_springs();
  w.near_pairs.hold_springs = w.near_walls.hold_springs = false;  // slots name bodies by their old numbers
  Bodies& b = w.bodies;
  const dem::Centres at = dem::sphere_centres(b, w.spheres);
  const std::vector<Origin> from = origins(b, clusters);
  for (auto* field : {&b.x, &b.y, &b.z, &b.vx, &b.vy, &b.vz, &b.qw, &b.qx, &b.qy, &b.qz, &b.lx, &b.ly, &b.lz, &b.wx, &b.wy, &b.wz,
                      &b.inverse_mass, &b.inverse_ix, &b.inverse_iy, &b.inverse_iz, &b.mass, &b.solid_volume, &b.parent_diameter,
                      &b.reach, &b.swing}) {
    take(from, *field);
  }
  take(from, b.load), take(from, b.gone), take(from, b.motion), take(from, b.placing);
  const std::vector<std::int32_t> first = std::move(b.first_sphere);
  b.first_sphere = {0};
  for (std::size_t j = 0; j < from.size(); ++j) {
    const auto [body, sphere] = from[j];
    const std::int32_t begin = sphere < 0 ? first[body] : sphere, end = sphere < 0 ? first[body + 1] : sphere + 1;
    b.first_sphere.push_back(end);
    for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s) w.spheres.body[s] = static_cast<std::int32_t>(j);
    if (sphere < 0) continue;
    const auto s = static_cast<std::size_t>(sphere);
    make_single(b, j, {at.x[s], at.y[s], at.z[s]}, w.spheres.radius[s]);
    w.spheres.ox[s] = w.spheres.oy[s] = w.spheres.oz[s] = 0;
  }
  w.lists_stale = true;
}

}  // namespace regolab::effects
