/// Near pairs of spheres of different clusters, with the sliding history of each. Canonical order (a < b, sorted by a then b):
/// forces are summed in this order, so results do not depend on when, or with what skin, the list was built.
#pragma once
#include <cstdint>
#include <vector>

#include "worker/dem/bodies.h"
#include "worker/dem/cell_grid.h"

namespace regolab::dem {

/// Tangential springs kept per slot. A slot whose last touch is not the step before starts anew.
struct History {
  std::vector<double> sx, sy, sz;            // [slots] [m]
  std::vector<std::int64_t> touched;         // [slots] step of the last touch

  void assign(std::size_t slots);
  template <class A>
  void archive(A& ar) { ar(sx, sy, sz, touched); }
};

/// Carries springs of the step before from one list to its successor. Both lists are in canonical order by (first, second), so
/// one merge does it; `fresh` must have its slots assigned.
struct ListKeys {
  const std::vector<std::int32_t>& first;
  const std::vector<std::int32_t>& second;
};
void carry_over(const ListKeys& old_keys, const History& old, const ListKeys& fresh_keys, std::int64_t step, History& fresh);

struct PairList {
  std::vector<std::int32_t> a, b;            // [n_pairs] sphere indices, a < b
  std::vector<double> sum_of_radii;          // [n_pairs] [m]
  History history;                           // [n_pairs]

  template <class A>
  void archive(A& ar) { ar(a, b, sum_of_radii, history); }
};

/// Every pair of spheres of different, present clusters with a gap below `skin`. History is carried over by pair.
void build_pairs(const Bodies& bodies, const Spheres& spheres, double skin, std::int64_t step, CellGrid& grid, PairList& pairs);

}  // namespace regolab::dem
