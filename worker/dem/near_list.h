/// What may touch in the next steps: the listed pairs and wall contacts closer than their margins, each in a slot that keeps its
/// spring in place, and the few spheres they need.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "worker/dem/margins.h"
#include "worker/dem/pair_list.h"
#include "worker/dem/springs.h"
#include "worker/dem/walls.h"

namespace regolab::dem {

/// The spheres of the near slots alone, side by side: only they are placed each step.
struct Balls {
  std::vector<std::int32_t> body;          // [n_balls] in the order of the spheres
  std::vector<Quad> offset;                // [n_balls] from the centre of mass in the principal frame, and radius [m]
  std::vector<Quad> at;                    // [n_balls] in space, and radius [m]
  std::vector<std::int32_t> of_sphere;     // [n_spheres] ball of a sphere; only those listed are meant
};

inline constexpr double kApart = -1.0;  ///< stands for the normal force of a wall slot that does not touch; none is negative

/// Near pairs, or near wall contacts (then `second` is the wall, and nothing stands under b). A slot that does not touch holds
/// zeros. Arrays have room for a whole pack past the count, and the indices there repeat the last.
struct Slots {
  std::size_t count = 0;
  std::vector<std::int32_t> first, second;   // [count] sphere and sphere, or sphere and wall: the canonical order
  std::vector<std::int32_t> body_a, body_b;  // [count]
  std::vector<std::int32_t> ball_a, ball_b;  // [count]
  std::vector<std::int32_t> onto_b;          // [count] cluster b, or ~cell where it belongs to another slab
  std::vector<double> root_mass;             // [count] root of the effective mass [kg^0.5]
  std::vector<double> sx, sy, sz;            // [count] spring [m]
  std::vector<double> fx, fy, fz;            // [count] force on a in the last step [N]
  std::vector<double> rx, ry, rz;            // [count] rolling angle, where contacts resist rolling
  std::vector<double> normal, shear;         // [count] walls: normal force or kApart, and size of the rest [N]
  bool rolls = false;                        ///< contacts resist rolling
  bool hold_springs = false;                 ///< false until springs were given to these slots
};

/// Listed pairs of a stretch whose gap is below the sum of their clusters' margins, to the slots from its begin on; returns how
/// many. REQUIRES: make_room_for_pairs().
std::size_t list_near_pairs(const PairList& pairs, const Spheres& spheres, const Centres& at, const Margins& margins, Stretch stretch,
                            Slots& slots);
void make_room_for_pairs(std::size_t listed, Slots& slots);
/// Closes the gap between slots [0, count) and the `more` that stand from `begin` on.
void append_pairs(std::size_t begin, std::size_t more, Slots& slots);

/// Wall contacts whose gap is below the cluster's margin and the walls'.
void list_near_walls(const Bodies& bodies, const Spheres& spheres, const Centres& at, const Walls& walls, const Margins& margins,
                     double wall_margin, Slots& slots);

/// What the law needs besides the motion; springs relaxed.
void fill_pair_slots(const Bodies& bodies, Slots& slots);
void fill_wall_slots(const Bodies& bodies, Slots& slots);

/// The spheres that the slots name, and where each slot finds its own.
void collect_balls(const Spheres& spheres, Slots& pairs, Slots& walls, Balls& balls);

/// A stretch of balls to where their clusters are. REQUIRES: placing is published.
void place_balls(const Bodies& bodies, Stretch stretch, Balls& balls);

/// Springs of the slots that touch, in canonical order; and back. Both are sorted alike, so one merge does it.
void take_springs(const Slots& slots, Springs& springs);
void give_springs(const Springs& springs, Slots& slots);

}  // namespace regolab::dem
