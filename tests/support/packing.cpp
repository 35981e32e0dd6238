#include "support/packing.h"

#include <algorithm>
#include <cmath>

#include "worker/generate/parents.h"
#include "worker/generate/replacement.h"

namespace regolab::test {
namespace {

constexpr double kSide = 0.04;  // [m]

Vec3 random_vector(const generate::Random& random, std::uint64_t particle, std::uint64_t draw, double most) {
  const auto component = [&](std::uint64_t k) {
    return most * (2 * random.uniform(generate::Purpose::kWitness, particle, 3 * draw + k) - 1);
  };
  return {component(0), component(1), component(2)};
}

}  // namespace

World swarm(const Swarm& settings) {
  dem::LinearLaw law = elastic_law(1e4);
  law.tangential_stiffness = 0.75e4;
  law.friction = settings.friction;
  law.damping_is_ratio = true;
  law.normal_damping = law.tangential_damping = 2 * settings.damping * std::sqrt(law.normal_stiffness);
  World world = empty_world(law);
  const generate::Random random(settings.seed);
  const double largest = 0.008;
  const auto parents = generate::place_parents(generate::parent_diameters(settings.clusters, largest, random), kSide, kSide,
                                               0.2, 0.02, random);
  const Micro micro{.largest_diameter = largest, .kind = ParticleKind::kMixture, .rotation = Rotation::kXZ};
  generate::replace_parents(parents.value(), micro, 0.4, random, world);
  world.skin = 0.1 * largest;
  world.gravity = settings.gravity;
  for (int axis = 0; axis < 3; ++axis) {
    add_wall(world, 2 * axis, 0, settings.friction);
    add_wall(world, 2 * axis + 1, axis == 2 ? std::max(kSide, parents->fill_height) : kSide, settings.friction);
  }
  for (int body = 0; body < world.bodies.count(); ++body) {
    const auto particle = static_cast<std::uint64_t>(body);
    set_velocity(world, body, random_vector(random, particle, 1, settings.speed));
    set_spin(world, body, random_vector(random, particle, 2, 100 * settings.speed));
  }
  world.dt = dem::stable_step(world, 0.15);
  return world;
}

World pressed_packing(int clusters, double friction) {
  World world = swarm({.clusters = clusters, .seed = 5, .speed = 0.05, .friction = friction, .damping = 0.3});
  constexpr double kWanted = 5.0, kSpeed = 0.1;  // force of each wall [N], its speed inwards without force [m/s]
  world.drag = 200;                              // quiets the grains that the walls sweep up
  for (auto& wall : world.walls.wall) wall.friction = 0;
  int pressed_looks = 0;
  for (int look = 0; look < 4000 && pressed_looks < 20; ++look) {
    bool pressed = true;
    for (int w = 0; w < dem::kWalls; ++w) {
      const double lacking = 1 - world.walls[w].force / kWanted;
      world.walls[w].velocity = dem::inward(w) * kSpeed * std::clamp(lacking, -1.0, 1.0);
      pressed = pressed && lacking < 0.2;
    }
    pressed_looks = pressed ? pressed_looks + 1 : 0;
    run(world, 20);
  }
  for (auto& wall : world.walls.wall) wall.velocity = 0;
  world.drag = 60;
  for (int look = 0; look < 60 && dem::unbalanced_force_ratio(world) > 1e-7; ++look) run(world, 1000);
  return world;
}

}  // namespace regolab::test
