/// Six plane walls, axis-aligned, and a plate among the grains, with the grains' own contact law.
#pragma once
#include <array>
#include <limits>

#include "worker/dem/bodies.h"

namespace regolab::dem {

enum WallId { kLeft = 0, kRight = 1, kFront = 2, kBack = 3, kFloor = 4, kTop = 5, kPlate = 6 };  // x-, x+, y-, y+, z-, z+
inline constexpr int kWalls = 6;    ///< planes
inline constexpr int kWallIds = 7;  ///< and the plate

struct Wall {
  bool present = false;
  double position = 0;   ///< along its axis; of the plate, its centre along z [m]
  double velocity = 0;   ///< along its axis, positive with the axis [m/s]
  double friction = 0;   ///< tan of the friction angle with grains
  double force = 0;      ///< last step: normal force of the grains on the wall, positive outward [N]
  double shear = 0;      ///< last step: sum of tangential force sizes [N]
  int contacts = 0;      ///< last step

  template <class A>
  void archive(A& ar) { ar(present, position, velocity, friction, force, shear, contacts); }
};

/// What the plate is besides a wall: a rigid cuboid, edges along the axes, that moves along z.
struct Plate {
  double x = 0, y = 0;  ///< of its centre [m]
  Vec3 half{};          ///< half its edges [m]
  Vec3 force{};         ///< last step: of the grains on it, friction included [N]

  template <class A>
  void archive(A& ar) { ar(x, y, half, force); }
};

struct Walls {
  std::array<Wall, kWallIds> wall;
  Plate plate;  ///< meant while wall kPlate is present
  /// The floor ends here along x: beyond it grains fall past its edge [m].
  double floor_end = std::numeric_limits<double>::infinity();

  Wall& operator[](int w) { return wall[static_cast<std::size_t>(w)]; }
  const Wall& operator[](int w) const { return wall[static_cast<std::size_t>(w)]; }
  /// Without the plate, which only one test has: that test saves it, and stored beds stay as they are.
  template <class A>
  void archive(A& ar) {
    for (int w = 0; w < kWalls; ++w) ar((*this)[w]);
    ar(floor_end);
  }
  template <class A>
  void archive_plate(A& ar) { ar((*this)[kPlate], plate); }
};

// Of the planes only:
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
bool move_walls(double dt, double margin, const std::array<double, kWallIds>& from, Walls& walls);

}  // namespace regolab::dem
