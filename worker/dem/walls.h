/// Six plane walls, axis-aligned, with the grains' own contact law and a list of the spheres near them.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/pair_list.h"

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

  std::vector<std::int32_t> sphere;  // [slots] near spheres, by wall then sphere
  std::vector<std::int32_t> id;      // [slots] WallId
  History history;                   // [slots]
  std::array<double, kWalls> position_at_build{};

  Wall& operator[](int w) { return wall[static_cast<std::size_t>(w)]; }
  const Wall& operator[](int w) const { return wall[static_cast<std::size_t>(w)]; }
  template <class A>
  void archive(A& ar) { ar(wall, floor_end, sphere, id, history, position_at_build); }
};

inline int axis_of(int wall) { return wall / 2; }
/// +1 for walls at the low end (their inward normal points along the axis), -1 at the high end.
inline double inward(int wall) { return wall % 2 == 0 ? 1.0 : -1.0; }

/// Where a sphere meets a wall: inward normal (unit, from wall to sphere) and overlap (negative = gap).
struct WallGap {
  double nx, ny, nz, overlap;
};
WallGap gap_to_wall(const Walls& walls, int id, double x, double y, double z, double radius);

/// Lists spheres of present clusters within `skin` of each wall; history is carried over.
void build_wall_list(const Bodies& bodies, const Spheres& spheres, double skin, std::int64_t step, Walls& walls);

/// Moves the walls by one step.
void move_walls(Walls& walls, double dt);

}  // namespace regolab::dem
