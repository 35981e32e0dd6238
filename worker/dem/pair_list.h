/// Near pairs of spheres of different clusters, clusters first: bounding balls, then spheres. Canonical order (a < b, sorted by a
/// then b): forces are summed in this order, so results do not depend on when, or with what skin, the list was built.
#pragma once
#include <cstdint>
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/cell_grid.h"
#include "worker/dem/margins.h"

namespace regolab::dem {

/// Where the clusters stood when a list was built.
struct Poses {
  std::vector<double> x, y, z, qw, qx, qy, qz;  // [n]
};

struct PairList {
  std::vector<std::int32_t> a, b;      // [n_pairs] sphere indices, a < b
  std::vector<double> sum_of_radii;    // [n_pairs] [m]
  Poses at_build;
  std::vector<double> allowance;       // [n] how far each cluster may get from there [m]
  double attraction = 0;               ///< listed so much farther: see Margins [m]
  std::vector<double> swing;           // [n] farthest sphere centre that counts when a cluster turns; 0 of a tumbling one [m]

  struct Scratch {
    Centres at;                        // [n_spheres + a pack] where the search takes them to be
    std::vector<double> radius;        // [n_spheres + a pack]
    std::vector<double> reach;         // [n]
    std::vector<std::int32_t> others;
    CellGrid grid;
  } scratch;
};

/// Every pair of spheres of different, present clusters with a gap below the sum of their clusters' allowances (set in `pairs`) and `attraction`. Two
/// clusters held fixed make no pairs. A cluster whose turn alone would use up half its allowance in `time` [s] is listed by its
/// bounding ball: then its turn does not matter.
void build_pairs(const Bodies& bodies, const Spheres& spheres, const Centres& centres, double time, PairList& pairs);

/// True when a sphere of some cluster, moved since and free to go its margin farther, may get beyond its allowance. Conservative:
/// sphere centres move at most |dx| + swing * angle.
bool moved_beyond(const PairList& pairs, const Bodies& bodies, const Margins& margins);

}  // namespace regolab::dem
