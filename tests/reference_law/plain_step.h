/// The forces of one step a second time: every pair of spheres is looked at, without lists, margins, slots or packs; motion is taken
/// about the centres of mass, and so are torques.
#pragma once
#include <map>
#include <utility>
#include <vector>

#include "reference_law/plain_law.h"

namespace regolab::test {

struct PlainContact {
  int body_a = 0, body_b = -1;  ///< b is -1 at a wall
  Vec3 normal, arm_a{}, arm_b{};  ///< arms from each centre of mass to the contact point [m]
  double overlap = 0;
  bool at_edge = false;         ///< of a floor that ends, or of the plate
  PlainAnswer answer;
};

using Pair = std::pair<int, int>;  ///< sphere and sphere, or wall and sphere
using SpringsBefore = std::map<Pair, Vec3>;

/// The springs that the last step left, by the contacts that touch now.
struct Springs {
  SpringsBefore pairs, walls;
};
Springs springs_of(const World& world);

struct PlainForces {
  std::map<Pair, PlainContact> pairs, walls;
  std::vector<Vec3> force, torque;  // [bodies] torque about the centre of mass
  double wall_force[dem::kWallIds] = {}, wall_shear[dem::kWallIds] = {};
  int wall_contacts[dem::kWallIds] = {};
  Vec3 on_plate{};
};

/// At the present positions and velocities of `world`, with the springs of the step before.
PlainForces plain_forces(const World& world, const PlainLaw& law, const Springs& before);

}  // namespace regolab::test
