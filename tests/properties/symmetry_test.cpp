/// The laws know no direction, and no order of the bodies: turned, mirrored or renumbered, the same motion up to round-off.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "support/packing.h"

namespace regolab::test {
namespace {

using Map = std::function<Vec3(const Vec3&)>;

/// The clusters of `from`, in the order `order`, with positions and velocities mapped by `point` and spins by `turn_axis`
/// (the two differ for a mirror). Clusters are made anew from their spheres, so that nothing but the geometry is carried
/// over.
World rebuilt(const World& from, const std::vector<int>& order, const Map& point, const Map& turn_axis) {
  World to = empty_world(from.law);
  to.dt = from.dt;
  to.gravity = from.gravity;
  const dem::Centres at = dem::sphere_centres(from.bodies, from.spheres);
  for (const int body : order) {
    const auto b = static_cast<std::size_t>(body);
    dem::ClusterSpec spec{.density = 2930, .parent_diameter = from.bodies.parent_diameter[b]};
    for (auto s = from.bodies.first_sphere[b]; s < from.bodies.first_sphere[b + 1]; ++s) {
      const auto k = static_cast<std::size_t>(s);
      spec.centre.push_back(point({at.x[k], at.y[k], at.z[k]}));
      spec.radius.push_back(from.spheres.radius[k]);
    }
    spec.mass_factor = from.bodies.mass[b] / (2930 * from.bodies.solid_volume[b]);
    const int added = dem::add_cluster(spec, to.bodies, to.spheres);
    set_velocity(to, added, point(velocity(from, body)));
    set_spin(to, added, turn_axis(spin(from, body)));
  }
  to.skin = from.skin;
  return to;
}

std::vector<int> in_order(const World& world) {
  std::vector<int> order(static_cast<std::size_t>(world.bodies.count()));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// A swarm about to collide with itself; its walls are added by the tests, so that they can be moved with the map.
World open_swarm() {
  World world = swarm({.clusters = 40, .seed = 11, .speed = 0.5});
  for (auto& wall : world.walls.wall) wall.present = false;
  return world;
}

constexpr int kSteps = 2500;  // enough for dozens of impacts, too few for round-off to grow visible

/// Largest distance between where the clusters of `a`, mapped, and those of `b` are [m].
double largest_difference(const World& a, const World& b, const std::vector<int>& order, const Map& point) {
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, norm(point(position(a, order[i])) - position(b, static_cast<int>(i))));
  }
  return largest;
}

void expect_same_motion(World a, World b, const std::vector<int>& order, const Map& point) {
  const double energy = dem::energies(a).kinetic;
  run(a, kSteps);
  run(b, kSteps);
  EXPECT_LT(dem::energies(a).kinetic, 0.97 * energy) << "hardly any impacts";
  EXPECT_LT(largest_difference(a, b, order, point), 1e-9);
}

TEST(Symmetry, TurningEverythingByNinetyDegreesTurnsTheMotion) {
  World world = open_swarm();
  const Map turned = [](const Vec3& v) { return Vec3{0.04 * 0 - v[1], v[0], v[2]}; };
  World other = rebuilt(world, in_order(world), turned, turned);
  add_wall(world, dem::kLeft, 0, 0.4);  // x = 0 becomes y = 0
  add_wall(other, dem::kFront, 0, 0.4);
  add_wall(world, dem::kBack, 0.04, 0.4);  // y = 0.04 becomes x = -0.04
  add_wall(other, dem::kLeft, -0.04, 0.4);
  expect_same_motion(std::move(world), std::move(other), in_order(world), turned);
}

TEST(Symmetry, TheMirrorImageMovesAsTheMirrorImage) {
  World world = open_swarm();
  const Map mirrored = [](const Vec3& v) { return Vec3{-v[0], v[1], v[2]}; };
  const Map axial = [](const Vec3& w) { return Vec3{w[0], -w[1], -w[2]}; };
  World other = rebuilt(world, in_order(world), mirrored, axial);
  add_wall(world, dem::kRight, 0.04, 0.4);
  add_wall(other, dem::kLeft, -0.04, 0.4);
  add_wall(world, dem::kFloor, 0, 0.4);
  add_wall(other, dem::kFloor, 0, 0.4);
  expect_same_motion(std::move(world), std::move(other), in_order(world), mirrored);
}

TEST(Symmetry, NumberingTheClustersOtherwiseChangesNothing) {
  World world = open_swarm();
  std::vector<int> order = in_order(world);
  std::reverse(order.begin(), order.end());
  std::rotate(order.begin(), order.begin() + 7, order.end());
  const Map same = [](const Vec3& v) { return v; };
  World other = rebuilt(world, order, same, same);
  for (World* w : {&world, &other}) {
    add_wall(*w, dem::kFloor, 0, 0.4);
    add_wall(*w, dem::kRight, 0.04, 0.4);
  }
  expect_same_motion(std::move(world), std::move(other), order, same);
}

TEST(Symmetry, AMovingObserverSeesTheSameMotion) {
  World world = open_swarm();
  World other = world;
  const Vec3 wind{0.3, -0.2, 0.1};
  for (int body = 0; body < other.bodies.count(); ++body) set_velocity(other, body, velocity(other, body) + wind);
  const double time = kSteps * world.dt;
  expect_same_motion(std::move(world), std::move(other), in_order(other), [&](const Vec3& v) { return v + time * wind; });
}

}  // namespace
}  // namespace regolab::test
