#include "worker/dem/crossings.h"

#include <algorithm>


namespace regolab::dem {
namespace {

using Cuts = std::array<std::size_t, kSlabs + 1>;

/// Where the slots of each slab begin, after the clusters' cuts.
Cuts slot_cuts(const Slots& slots, const Cuts& bodies, std::size_t slabs) {
  Cuts cuts{};
  const auto begin = slots.body_a.begin(), end = begin + static_cast<std::ptrdiff_t>(slots.count);
  for (std::size_t p = 0; p <= slabs; ++p) {
    cuts[p] = static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<std::int32_t>(bodies[p])) - begin);
  }
  return cuts;
}

}  // namespace

void list_crossings(std::size_t n_bodies, std::size_t slabs, const Slots& walls, Slots& pairs, Crossings& c) {
  Cuts bodies{};
  for (std::size_t p = 0; p <= slabs; ++p) bodies[p] = cut(n_bodies, p, slabs);
  c.pairs = slot_cuts(pairs, bodies, slabs);
  c.walls = slot_cuts(walls, bodies, slabs);
  std::copy_n(pairs.body_b.begin(), pairs.count, pairs.onto_b.begin());
  const auto each_crossing = [&](auto visit) {
    for (std::size_t p = 0; p + 1 < slabs; ++p) {  // the last slab has no one after it
      for (std::size_t k = c.pairs[p]; k < c.pairs[p + 1]; ++k) {
        const auto b = static_cast<std::size_t>(pairs.body_b[k]);
        if (b < bodies[p + 1]) continue;
        visit(k, static_cast<std::size_t>(std::upper_bound(bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(slabs), b) -
                                          bodies.begin()) - 1);
      }
    }
  };
  c.begin = {};
  each_crossing([&](std::size_t, std::size_t slab) { ++c.begin[slab + 1]; });
  for (std::size_t p = 0; p < slabs; ++p) c.begin[p + 1] += c.begin[p];
  c.cell.assign(c.begin[slabs], Load{});
  c.onto.resize(c.cell.size());
  auto next = c.begin;
  each_crossing([&](std::size_t k, std::size_t slab) {
    const std::size_t cell = next[slab]++;
    c.onto[cell] = pairs.body_b[k];
    pairs.onto_b[k] = ~static_cast<std::int32_t>(cell);
  });
}

void add_crossings(Stretch cells, Crossings& c, Load* loads) {
  for (std::size_t k = cells.begin; k < cells.end; ++k) {
    Load& on = loads[c.onto[k]];
    Load& cell = c.cell[k];
    on.fx += cell.fx, on.fy += cell.fy, on.fz += cell.fz;
    on.tx += cell.tx, on.ty += cell.ty, on.tz += cell.tz;
    cell = Load{};
  }
}

}  // namespace regolab::dem
