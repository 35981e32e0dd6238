/// A large bed is cut into slabs of clusters, whatever the number of threads: each slab adds up its own loads, and what its contacts
/// give to clusters of another slab waits in cells that are added after. So threads never write to the same cluster, and the order of
/// every sum, hence every bit, is that of one thread.
#pragma once
#include "worker/dem/near_list.h"
#include "worker/dem/simd/pack.h"

namespace regolab::dem {

inline constexpr std::size_t kSlabs = 8;         ///< no more threads than that share a step
inline constexpr int kMostInOneSlab = 2000;      ///< clusters; more are cut

/// Where part p of n things begins: at a multiple of kMostLanes.
inline std::size_t cut(std::size_t n, std::size_t p, std::size_t parts) {
  return p >= parts ? n : n * p / parts / kMostLanes * kMostLanes;
}

struct Crossings {
  std::vector<Load> cell;                                ///< [n_cells] by receiving slab, then pairs in slot order
  std::vector<std::int32_t> onto;                        ///< [n_cells] cluster
  std::array<std::size_t, kSlabs + 1> begin{};           ///< of each slab's cells
  std::array<std::size_t, kSlabs + 1> pairs{}, walls{};  ///< where each slab's slots begin: those whose `body_a` is its own
};

/// Cuts the slots and gives a cell to each that crosses. REQUIRES: slots sorted by body_a, which the canonical order is.
void list_crossings(std::size_t n_bodies, std::size_t slabs, const Slots& walls, Slots& pairs, Crossings& crossings);

/// A stretch of cells onto their clusters, and empty again.
void add_crossings(Stretch cells, Crossings& crossings, Load* loads);

}  // namespace regolab::dem
