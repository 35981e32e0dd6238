#include "worker/dem/walls.h"

#include <cmath>

namespace regolab::dem {
namespace {

/// A floor that ends is a solid block: its top, its edge, and the face below the edge. (dx, dz) from the edge to the centre.
WallGap gap_to_block(double dx, double dz, double radius) {
  if (dx > 0 && dz > 0) {
    const double distance = std::hypot(dx, dz);
    return {dx / distance, 0, dz / distance, radius - distance};
  }
  if (dx > dz) return {1, 0, 0, radius - dx};
  return {0, 0, 1, radius - dz};
}

}  // namespace

WallGap gap_to_wall(const Walls& walls, int id, double x, double y, double z, double radius) {
  const double at[3] = {x, y, z};
  const Wall& wall = walls[id];
  const int axis = axis_of(id);
  const double sign = inward(id);
  if (id == kFloor && std::isfinite(walls.floor_end)) return gap_to_block(x - walls.floor_end, z - wall.position, radius);
  const double overlap = radius - sign * (at[axis] - wall.position);
  return {axis == 0 ? sign : 0.0, axis == 1 ? sign : 0.0, axis == 2 ? sign : 0.0, overlap};
}

void build_wall_list(const Bodies& bodies, const Spheres& spheres, double skin, std::int64_t step, Walls& walls) {
  std::vector<std::int32_t> sphere, id;
  for (int w = 0; w < kWalls; ++w) {
    if (!walls[w].present) continue;
    for (int s = 0; s < spheres.count(); ++s) {
      const auto i = static_cast<std::size_t>(s);
      const auto body = static_cast<std::size_t>(spheres.body[i]);
      if (bodies.gone[body] || bodies.inverse_mass[body] == 0.0) continue;
      if (gap_to_wall(walls, w, spheres.x[i], spheres.y[i], spheres.z[i], spheres.radius[i]).overlap > -skin) {
        sphere.push_back(s);
        id.push_back(w);
      }
    }
  }
  History history;
  history.assign(sphere.size());
  carry_over({walls.id, walls.sphere}, walls.history, {id, sphere}, step, history);
  walls.sphere = std::move(sphere);
  walls.id = std::move(id);
  walls.history = std::move(history);
  for (int w = 0; w < kWalls; ++w) walls.position_at_build[static_cast<std::size_t>(w)] = walls[w].position;
}

void move_walls(Walls& walls, double dt) {
  for (Wall& wall : walls.wall) wall.position += wall.velocity * dt;
}

}  // namespace regolab::dem
