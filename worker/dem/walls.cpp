#include "worker/dem/walls.h"

#include <cmath>

namespace regolab::dem {

namespace {

/// A centre inside is pushed out along the nearest face: its distance is negative.
WallDistance plate_distance(const Walls& walls, const Vec3& place) {
  const Vec3 centre{walls.plate.x, walls.plate.y, walls[kPlate].position};
  Vec3 side, beyond;  // which way, and how far beyond each pair of faces
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double from_centre = place[axis] - centre[axis];
    side[axis] = from_centre < 0 ? -1.0 : 1.0;
    beyond[axis] = std::abs(from_centre) - walls.plate.half[axis];
  }
  const std::size_t nearest = beyond[0] >= beyond[1] && beyond[0] >= beyond[2] ? 0 : beyond[1] >= beyond[2] ? 1 : 2;
  if (!(beyond[nearest] > 0)) {
    Vec3 normal{0, 0, 0};
    normal[nearest] = side[nearest];
    return {beyond[nearest], normal};
  }
  for (double& b : beyond) b = b > 0 ? b : 0.0;
  const double distance = std::sqrt(beyond[0] * beyond[0] + beyond[1] * beyond[1] + beyond[2] * beyond[2]);
  return {distance, {side[0] * beyond[0] / distance, side[1] * beyond[1] / distance, side[2] * beyond[2] / distance}};
}

}  // namespace

WallDistance wall_distance(const Walls& walls, int id, const Vec3& place) {
  if (id == kPlate) return plate_distance(walls, place);
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
  if (walls[kPlate].present) power -= walls.plate.force[2] * walls[kPlate].velocity;
  return power;
}

bool move_walls(double dt, double margin, const std::array<double, kWallIds>& from, Walls& walls) {
  bool left = false;
  for (std::size_t id = 0; id < walls.wall.size(); ++id) {
    Wall& wall = walls.wall[id];
    wall.position += wall.velocity * dt;
    left |= std::abs(wall.position - from[id]) > margin;
  }
  return left;
}

}  // namespace regolab::dem
