#include "reference_law/plain_step.h"

#include <algorithm>
#include <cmath>

namespace regolab::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// v turned by the unit quaternion (w, q): v + 2 q x (q x v + w v).
Vec3 turned(const World& world, int body, const Vec3& v) {
  const auto& b = world.bodies;
  const Vec3 q{b.qx[at(body)], b.qy[at(body)], b.qz[at(body)]};
  return v + 2 * cross(q, cross(q, v) + b.qw[at(body)] * v);
}

struct Sphere {
  int body;
  Vec3 centre;
  double radius;
};

std::vector<Sphere> placed_spheres(const World& world) {
  std::vector<Sphere> out;
  const auto& s = world.spheres;
  for (int i = 0; i < s.count(); ++i) {
    const int body = s.body[at(i)];
    out.push_back({body, position(world, body) + turned(world, body, {s.ox[at(i)], s.oy[at(i)], s.oz[at(i)]}), s.radius[at(i)]});
  }
  return out;
}

Vec3 point_velocity(const World& world, int body, const Vec3& arm) {
  return velocity(world, body) + cross(spin(world, body), arm);
}

double effective_mass(const World& world, int a, int b) {
  const double m = world.bodies.mass[at(a)], n = world.bodies.mass[at(b)];
  if (world.bodies.is_fixed(a)) return n;
  if (world.bodies.is_fixed(b)) return m;
  return m * n / (m + n);
}

Vec3 spring_before(const SpringsBefore& springs, const Pair& pair) {
  const auto found = springs.find(pair);
  return found == springs.end() ? Vec3{0, 0, 0} : found->second;
}

/// From a wall to a sphere's centre.
struct Gap {
  Vec3 normal;
  double distance;
  bool at_edge = false;
};
/// The nearest place of a cuboid, or the shortest of the six ways out.
Gap from_plate(const dem::Walls& walls, const Vec3& p) {
  const Vec3 centre{walls.plate.x, walls.plate.y, walls[dem::kPlate].position}, low = centre - walls.plate.half,
             high = centre + walls.plate.half;
  Vec3 nearest;
  int beyond = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    nearest[axis] = std::clamp(p[axis], low[axis], high[axis]);
    beyond += nearest[axis] != p[axis];
  }
  if (beyond > 0) return {(1 / norm(p - nearest)) * (p - nearest), norm(p - nearest), beyond > 1};
  Gap out{{0, 0, 0}, -1e300};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (low[axis] - p[axis] > out.distance) out = {{0, 0, 0}, low[axis] - p[axis]}, out.normal[axis] = -1;
    if (p[axis] - high[axis] > out.distance) out = {{0, 0, 0}, p[axis] - high[axis]}, out.normal[axis] = 1;
  }
  return out;
}
Gap from_wall(const dem::Walls& walls, int id, const Vec3& p) {
  if (id == dem::kPlate) return from_plate(walls, p);
  if (id == dem::kFloor && std::isfinite(walls.floor_end)) {  // a block: all that is left of its end and below its top
    const Vec3 nearest{std::min(p[0], walls.floor_end), p[1], std::min(p[2], walls[id].position)};
    const Vec3 away = p - nearest;
    return {(1 / norm(away)) * away, norm(away), away[0] > 0 && away[2] > 0};
  }
  const Vec3 inward[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const double along = p[at(id / 2)] - walls[id].position;
  return {inward[id], id % 2 == 0 ? along : -along};
}

void add_pairs(const World& world, const PlainLaw& law, const std::vector<Sphere>& spheres, const Springs& before, PlainForces& out) {
  for (int i = 0; i < world.spheres.count(); ++i) {
    for (int j = i + 1; j < world.spheres.count(); ++j) {
      const Sphere &a = spheres[at(i)], &b = spheres[at(j)];
      const Vec3 apart = a.centre - b.centre;
      const double overlap = a.radius + b.radius - norm(apart);
      if (a.body == b.body || overlap <= 0) continue;
      if (world.bodies.is_fixed(a.body) && world.bodies.is_fixed(b.body)) continue;
      PlainContact c{.body_a = a.body, .body_b = b.body, .normal = (1 / norm(apart)) * apart, .overlap = overlap};
      const Vec3 middle = a.centre - (a.radius - 0.5 * overlap) * c.normal;
      c.arm_a = middle - position(world, a.body);
      c.arm_b = middle - position(world, b.body);
      c.answer = plain_contact(law, world.dt,
                               {.normal = c.normal,
                                .overlap = overlap,
                                .velocity = point_velocity(world, a.body, c.arm_a) - point_velocity(world, b.body, c.arm_b),
                                .spring = spring_before(before.pairs, {i, j}),
                                .friction = world.law.friction,
                                .mass = effective_mass(world, a.body, b.body)});
      out.pairs[{i, j}] = c;
    }
  }
}

void add_walls(const World& world, const PlainLaw& law, const std::vector<Sphere>& spheres, const Springs& before, PlainForces& out) {
  for (int id = 0; id < dem::kWallIds; ++id) {
    for (int i = 0; i < world.spheres.count(); ++i) {
      const Sphere& a = spheres[at(i)];
      if (!world.walls[id].present || world.bodies.is_fixed(a.body)) continue;
      const Gap gap = from_wall(world.walls, id, a.centre);
      const double overlap = a.radius - gap.distance;
      if (overlap <= 0) continue;
      PlainContact c{.body_a = a.body, .normal = gap.normal, .overlap = overlap, .at_edge = gap.at_edge};
      c.arm_a = a.centre - gap.distance * gap.normal - position(world, a.body);
      Vec3 wall_velocity{0, 0, 0};
      wall_velocity[id == dem::kPlate ? 2 : at(id / 2)] = world.walls[id].velocity;
      c.answer = plain_contact(law, world.dt,
                               {.normal = c.normal,
                                .overlap = overlap,
                                .velocity = point_velocity(world, a.body, c.arm_a) - wall_velocity,
                                .spring = spring_before(before.walls, {id, i}),
                                .friction = world.walls[id].friction,
                                .mass = world.bodies.mass[at(a.body)]});
      out.walls[{id, i}] = c;
      const double push = dot(c.answer.force, c.normal);
      out.wall_force[id] += push;
      out.wall_shear[id] += norm(c.answer.force - push * c.normal);
      ++out.wall_contacts[id];
      if (id == dem::kPlate) out.on_plate = out.on_plate - c.answer.force;
    }
  }
}

}  // namespace

Springs springs_of(const World& world) {
  Springs out;
  for (const dem::Contact& c : dem::contacts(world)) out.pairs[{c.sphere_a, c.sphere_b}] = c.spring;
  for (const dem::Contact& c : dem::wall_contacts(world)) out.walls[{c.body_b, c.sphere_a}] = c.spring;
  return out;
}

PlainForces plain_forces(const World& world, const PlainLaw& law, const Springs& before) {
  PlainForces out;
  const std::vector<Sphere> spheres = placed_spheres(world);
  add_pairs(world, law, spheres, before, out);
  add_walls(world, law, spheres, before, out);
  out.force.assign(world.bodies.x.size(), {0, 0, 0});
  out.torque = out.force;
  const auto load = [&](int body, const Vec3& arm, const Vec3& force) {
    out.force[at(body)] = out.force[at(body)] + force;
    out.torque[at(body)] = out.torque[at(body)] + cross(arm, force);
  };
  for (const auto* contacts : {&out.pairs, &out.walls}) {
    for (const auto& [pair, c] : *contacts) {
      load(c.body_a, c.arm_a, c.answer.force);
      if (c.body_b >= 0) load(c.body_b, c.arm_b, -1 * c.answer.force);
    }
  }
  return out;
}

}  // namespace regolab::test
