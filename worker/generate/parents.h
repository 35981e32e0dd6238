/// Random generation: parent spheres without overlap in a box [article Sec. 2.2; protocols, section 1].
#pragma once
#include <optional>
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/generate/random.h"

namespace regolab::generate {

struct Parents {
  std::vector<dem::Vec3> centre;  // [n] [m], sorted along x
  std::vector<double> radius;     // [n] [m]
  double fill_height = 0;         ///< of the filling box [m]
};

/// Diameters uniform by number in [L_S/5, L_S]: one draw in each of n equal strata, so that small beds hold the law too.
std::vector<double> parent_diameters(int n, double largest, const Random& random, double finer = 0);

/// Placed largest first, at random, each `clearance` (a share of its radius) away from all others and from the walls, in a box of the
/// given base filled to `fraction` of spheres. Empty when a sphere finds no room in 20000 tries.
std::optional<Parents> place_parents(const std::vector<double>& diameters, double length, double width, double fraction,
                                     double clearance, const Random& random);

}  // namespace regolab::generate
