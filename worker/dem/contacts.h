/// The touching pairs of a step as flat arrays: gather, compute, scatter.
#pragma once
#include <cstdint>
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/laws/linear.h"
#include "worker/dem/pair_list.h"
#include "worker/dem/walls.h"

namespace regolab::dem {

/// Arrays of one step's contacts; `capacity` slots, of which each segment fills the front of its own stretch.
struct Contacts {
  std::vector<std::int32_t> slot;                 // index into the pair or wall list
  std::vector<std::int32_t> body_a, body_b;       // clusters (body_b = wall id for walls)
  std::vector<double> nx, ny, nz, overlap;        // from b to a; [m]
  std::vector<double> ax, ay, az, bx, by, bz;     // lever arms from each centre of mass to the contact point [m]
  std::vector<double> vx, vy, vz;                 // velocity of a relative to b there [m/s]
  std::vector<double> sx, sy, sz;                 // tangential spring [m]
  std::vector<double> friction, root_mass;        // see LinearLaw
  std::vector<double> fx, fy, fz;                 // on a [N]

  struct Segment {
    std::size_t begin = 0;  ///< first pair of its stretch, and first slot here
    std::size_t end = 0;    ///< past its last pair
    std::size_t count = 0;  ///< contacts found, at [begin, begin + count)
  };
  std::vector<Segment> segments;

  void reserve_slots(std::size_t n);
  std::size_t count() const;

  /// Visits every contact index in canonical order.
  template <class Visit>
  void each(Visit visit) const {
    for (const Segment& s : segments) {
      for (std::size_t k = s.begin; k < s.begin + s.count; ++k) visit(k);
    }
  }
};

/// Cuts `n` list entries into one stretch per thread. The cut does not show in the results.
void cut_segments(std::size_t n, int threads, Contacts& contacts);

/// One stretch: which listed pairs touch, and all that the law needs of them.
void gather_pairs(const Bodies& bodies, const Spheres& spheres, const PairList& pairs, const LinearLaw& law, std::int64_t step,
                  Contacts& contacts, Contacts::Segment& segment);
void gather_walls(const Bodies& bodies, const Spheres& spheres, const Walls& walls, const LinearLaw& law, std::int64_t step,
                  Contacts& contacts, Contacts::Segment& segment);

/// The law on one stretch: arithmetic only.
void apply_law(const LinearLaw& law, double dt, Contacts& contacts, const Contacts::Segment& segment);

/// Springs back to their list slots.
void store_history(const Contacts& contacts, std::int64_t step, History& history);

/// Forces and torques onto the clusters, one after the other in canonical order.
void scatter_pairs(const Contacts& contacts, Bodies& bodies);
void scatter_walls(const Contacts& contacts, Bodies& bodies, Walls& walls);

}  // namespace regolab::dem
