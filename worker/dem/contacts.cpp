#include "worker/dem/contacts.h"

#include <cmath>

namespace regolab::dem {
namespace {

Vec3 at(const Centres& c, std::size_t s) { return {c.x[s], c.y[s], c.z[s]}; }
Vec3 centre_of_mass(const Bodies& b, std::size_t i) { return {b.x[i], b.y[i], b.z[i]}; }

Vec3 arm_to(const Vec3& sphere, const Vec3& centre, double along, const Vec3& n) {
  return {sphere[0] - centre[0] + along * n[0], sphere[1] - centre[1] + along * n[1], sphere[2] - centre[2] + along * n[2]};
}

Contact from_slot(const Slots& s, std::size_t k) {
  Contact c{};
  c.body_a = s.body_a[k];
  c.spring = {s.sx[k], s.sy[k], s.sz[k]};
  c.force = {s.fx[k], s.fy[k], s.fz[k]};
  if (s.rolls) c.rolling = {s.rx[k], s.ry[k], s.rz[k]};
  return c;
}

}  // namespace

std::vector<Contact> contacts(const World& w, double gap) {
  std::vector<Contact> out;
  const Slots& slots = w.near_pairs;
  const Centres centres = sphere_centres(w.bodies, w.spheres);
  for (std::size_t k = 0; k < slots.count; ++k) {
    const auto a = static_cast<std::size_t>(slots.first[k]), b = static_cast<std::size_t>(slots.second[k]);
    const Vec3 pa = at(centres, a), pb = at(centres, b);
    const Vec3 d{pa[0] - pb[0], pa[1] - pb[1], pa[2] - pb[2]};
    const double distance2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2], reach = w.spheres.radius[a] + w.spheres.radius[b];
    if (!(distance2 < (reach + gap) * (reach + gap) && distance2 > 0.0)) continue;
    const double distance = std::sqrt(distance2), overlap = reach - distance;
    Contact c = from_slot(slots, k);
    c.sphere_a = slots.first[k], c.sphere_b = slots.second[k];
    c.body_b = slots.body_b[k];
    c.normal = {d[0] / distance, d[1] / distance, d[2] / distance};
    c.overlap = overlap;
    c.reduced_radius = w.spheres.radius[a] * w.spheres.radius[b] / reach;
    c.arm_a = arm_to(pa, centre_of_mass(w.bodies, static_cast<std::size_t>(c.body_a)), 0.5 * overlap - w.spheres.radius[a], c.normal);
    c.arm_b = arm_to(pb, centre_of_mass(w.bodies, static_cast<std::size_t>(c.body_b)), w.spheres.radius[b] - 0.5 * overlap, c.normal);
    out.push_back(c);
  }
  return out;
}

std::vector<Contact> wall_contacts(const World& w) {
  std::vector<Contact> out;
  const Slots& slots = w.near_walls;
  const Centres centres = sphere_centres(w.bodies, w.spheres);
  for (std::size_t k = 0; k < slots.count; ++k) {
    const auto s = static_cast<std::size_t>(slots.first[k]);
    const int id = slots.second[k];
    const Vec3 p = at(centres, s);
    Contact c = from_slot(slots, k);
    c.sphere_a = slots.first[k], c.sphere_b = -1;
    c.body_b = id;
    const auto [distance, normal] = wall_distance(w.walls, id, p);
    c.normal = normal;
    c.overlap = w.spheres.radius[s] - distance;
    c.reduced_radius = w.spheres.radius[s];
    if (!(c.overlap > 0.0)) continue;
    c.arm_a = arm_to(p, centre_of_mass(w.bodies, static_cast<std::size_t>(c.body_a)), -distance, c.normal);
    out.push_back(c);
  }
  return out;
}

}  // namespace regolab::dem
