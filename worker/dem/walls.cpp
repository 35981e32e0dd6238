#include "worker/dem/walls.h"

#include <algorithm>
#include <cmath>

namespace regolab::dem {

double gap_to_wall(const Walls& walls, int id, double x, double y, double z, double radius) {
  const double at[3] = {x, y, z};
  const double from_plane = inward(id) * (at[axis_of(id)] - walls[id].position);
  if (id != kFloor || !std::isfinite(walls.floor_end)) return from_plane - radius;
  // A floor that ends is a solid block: its top, its edge, and the face below the edge.
  const double from_face = x - walls.floor_end;
  if (from_face > 0 && from_plane > 0) return std::hypot(from_face, from_plane) - radius;
  return std::max(from_face, from_plane) - radius;
}

double wall_power(const Walls& walls) {
  double power = 0;
  for (int id = 0; id < kWalls; ++id) power += walls[id].force * inward(id) * walls[id].velocity;
  return power;
}

bool move_walls(double dt, double margin, const std::array<double, kWalls>& from, Walls& walls) {
  bool left = false;
  for (std::size_t id = 0; id < walls.wall.size(); ++id) {
    Wall& wall = walls.wall[id];
    wall.position += wall.velocity * dt;
    left |= std::abs(wall.position - from[id]) > margin;
  }
  return left;
}

}  // namespace regolab::dem
