#include "worker/dem/walls.h"

#include <cmath>

namespace regolab::dem {

WallDistance wall_distance(const Walls& walls, int id, const Vec3& place) {
  const double from_plane = inward(id) * (place[static_cast<std::size_t>(axis_of(id))] - walls[id].position);
  if (id != kFloor || !std::isfinite(walls.floor_end)) return {from_plane, normal_of(id)};
  // A floor that ends is a solid block: its top, its edge, and the face below the edge.
  const double from_face = place[0] - walls.floor_end;
  if (from_face > 0 && from_plane > 0) {
    const double from_edge = std::sqrt(from_face * from_face + from_plane * from_plane);
    return {from_edge, {from_face / from_edge, 0, from_plane / from_edge}};
  }
  if (from_face > from_plane) return {from_face, {1, 0, 0}};
  return {from_plane, {0, 0, 1}};
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
