#include "support/small_world.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/archive.h"

namespace regolab::test {
namespace {

std::size_t at(int body) { return static_cast<std::size_t>(body); }

/// R D R^T v with D the diagonal matrix d.
Vec3 in_principal_frame(const World& world, int body, const Vec3& d, const Vec3& v) {
  const auto r = dem::rotation_of(world.bodies, body);
  Vec3 p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = d[k] * (r[k] * v[0] + r[3 + k] * v[1] + r[6 + k] * v[2]);
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = r[3 * i] * p[0] + r[3 * i + 1] * p[1] + r[3 * i + 2] * p[2];
  return out;
}

}  // namespace

dem::LinearLaw elastic_law(double stiffness) {
  dem::LinearLaw law;
  law.normal_stiffness = law.tangential_stiffness = stiffness;
  return law;
}

World empty_world(const dem::LinearLaw& law) {
  World world;
  world.law = law;
  world.dt = 0.15 / std::sqrt(law.normal_stiffness);
  return world;
}

int add_clump(World& world, const generate::Clump& clump, const Vec3& centre, double density) {
  dem::ClusterSpec spec{.centre = clump.centre, .radius = clump.radius, .density = density};
  for (Vec3& c : spec.centre) c = c + centre;
  spec.parent_diameter = 2 * generate::farthest_point(clump);
  const int body = dem::add_cluster(spec, world.bodies, world.spheres);
  world.skin = std::max(world.skin, 0.2 * *std::max_element(clump.radius.begin(), clump.radius.end()));
  world.lists_stale = true;
  return body;
}

int add_sphere(World& world, const Vec3& centre, double radius, double density) {
  return add_clump(world, {{{0, 0, 0}}, {radius}}, centre, density);
}

void add_wall(World& world, int wall, double position, double friction) {
  world.walls[wall].present = true;
  world.walls[wall].position = position;
  world.walls[wall].friction = friction;
  world.lists_stale = true;
}

void set_velocity(World& world, int body, const Vec3& v) {
  world.bodies.vx[at(body)] = v[0];
  world.bodies.vy[at(body)] = v[1];
  world.bodies.vz[at(body)] = v[2];
}

void set_spin(World& world, int body, const Vec3& w) {
  const Vec3 l = inertia_times(world, body, w);
  auto& b = world.bodies;
  b.lx[at(body)] = l[0], b.ly[at(body)] = l[1], b.lz[at(body)] = l[2];
  b.wx[at(body)] = w[0], b.wy[at(body)] = w[1], b.wz[at(body)] = w[2];
}

void turn(World& world, int body, const Vec3& axis, double angle) {
  auto& b = world.bodies;
  const std::size_t i = at(body);
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  const Vec3 u = s * axis, q{b.qx[i], b.qy[i], b.qz[i]};
  const double w = b.qw[i];
  const Vec3 turned = c * q + (w * u + cross(u, q));  // quaternion product (c, u) (w, q)
  b.qw[i] = c * w - dot(u, q);
  b.qx[i] = turned[0], b.qy[i] = turned[1], b.qz[i] = turned[2];
  world.lists_stale = true;
}

Vec3 velocity(const World& world, int body) {
  return {world.bodies.vx[at(body)], world.bodies.vy[at(body)], world.bodies.vz[at(body)]};
}
Vec3 position(const World& world, int body) {
  return {world.bodies.x[at(body)], world.bodies.y[at(body)], world.bodies.z[at(body)]};
}
Vec3 spin(const World& world, int body) {
  return {world.bodies.wx[at(body)], world.bodies.wy[at(body)], world.bodies.wz[at(body)]};
}

void run(World& world, int steps) {
  for (int i = 0; i < steps; ++i) dem::step(world);
}

bool relax(World& world, int most_steps) {
  const double drag_before = world.drag;
  const double lightest = *std::min_element(world.bodies.mass.begin(), world.bodies.mass.end());
  world.drag = 0.2 * std::sqrt(world.law.normal_stiffness / lightest);
  bool still = false;
  for (int done = 0; done < most_steps && !still; done += 1000) {
    run(world, 1000);
    still = dem::unbalanced_force_ratio(world) < 1e-11;
  }
  world.drag = drag_before;
  for (int body = 0; body < world.bodies.count(); ++body) {
    set_velocity(world, body, {0, 0, 0});
    set_spin(world, body, {0, 0, 0});
  }
  return still;
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }

Vec3 inverse_inertia_times(const World& world, int body, const Vec3& v) {
  const auto& b = world.bodies;
  return in_principal_frame(world, body, {b.inverse_ix[at(body)], b.inverse_iy[at(body)], b.inverse_iz[at(body)]}, v);
}
Vec3 inertia_times(const World& world, int body, const Vec3& v) {
  const auto& b = world.bodies;
  return in_principal_frame(world, body,
                            {1 / b.inverse_ix[at(body)], 1 / b.inverse_iy[at(body)], 1 / b.inverse_iz[at(body)]}, v);
}

Vec3 total_momentum(const World& world) {
  Vec3 sum{};
  for (int body = 0; body < world.bodies.count(); ++body) sum = sum + world.bodies.mass[at(body)] * velocity(world, body);
  return sum;
}
Vec3 total_angular_momentum(const World& world) {
  Vec3 sum{};
  const auto& b = world.bodies;
  for (int body = 0; body < b.count(); ++body) {
    const Vec3 own{b.lx[at(body)], b.ly[at(body)], b.lz[at(body)]};
    sum = sum + own + b.mass[at(body)] * cross(position(world, body), velocity(world, body));
  }
  return sum;
}

std::string state_bytes(World& world) {
  dem::Saver saver;
  world.archive(saver);
  return saver.take();
}

}  // namespace regolab::test
