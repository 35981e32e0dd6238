/// Six plane walls, axis-aligned, with the grains' own contact law.
#pragma once
#include <array>
#include <limits>

#include "worker/dem/bodies.h"

namespace regolab::dem {

enum WallId { kLeft = 0, kRight = 1, kFront = 2, kBack = 3, kFloor = 4, kTop = 5 };  // x-, x+, y-, y+, z-, z+
inline constexpr int kWalls = 6;

struct Wall {
  bool present = false;
  double position = 0;   ///< along its axis [m]
  double velocity = 0;   ///< along its axis, positive with the axis [m/s]
  double friction = 0;   ///< tan of the friction angle with grains
  double force = 0;      ///< last step: normal force of the grains on the wall, positive outward [N]
  double shear = 0;      ///< last step: sum of tangential force sizes [N]
  int contacts = 0;      ///< last step

  template <class A>
  void archive(A& ar) { ar(present, position, velocity, friction, force, shear, contacts); }
};

struct Walls {
  std::array<Wall, kWalls> wall;
  /// The floor ends here along x: beyond it grains fall past its edge [m].
  double floor_end = std::numeric_limits<double>::infinity();

  Wall& operator[](int w) { return wall[static_cast<std::size_t>(w)]; }
  const Wall& operator[](int w) const { return wall[static_cast<std::size_t>(w)]; }
  template <class A>
  void archive(A& ar) { ar(wall, floor_end); }
};

inline int axis_of(int wall) { return wall / 2; }
/// +1 for walls at the low end (their inward normal points along the axis), -1 at the high end.
inline double inward(int wall) { return wall % 2 == 0 ? 1.0 : -1.0; }

/// Inward unit normal of a wall.
inline Vec3 normal_of(int wall) {
  Vec3 n{0, 0, 0};
  n[static_cast<std::size_t>(axis_of(wall))] = inward(wall);
  return n;
}

/// Distance of a place from a wall's surface, negative behind it [m], and the unit normal there, pointing away from the wall.
struct WallDistance {
  double distance;
  Vec3 normal;
};
WallDistance wall_distance(const Walls& walls, int id, const Vec3& place);

/// Work done by the walls on the grains per time, by the forces of the last step [W].
double wall_power(const Walls& walls);

/// Moves the walls by one step; true when one went farther than `margin` since `from` [m].
bool move_walls(double dt, double margin, const std::array<double, kWalls>& from, Walls& walls);

}  // namespace regolab::dem
