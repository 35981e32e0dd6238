/// Bins of points in a box, for neighbour search. Deterministic: within a bin, points stand in index order.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace regolab::dem {

class CellGrid {
 public:
  /// Bins at least `cell` wide. Points are clamped into the bounding box of all; a far stray costs bins only up to a limit.
  void build(std::span<const double> x, std::span<const double> y, std::span<const double> z, double cell);

  /// Calls visit(j) for every point in the 27 bins around point i (i itself included), bins in fixed order.
  template <class Visit>
  void around(int i, Visit visit) const {
    const auto c = cell_of_[static_cast<std::size_t>(i)];
    const int cx = c % nx_, cy = (c / nx_) % ny_, cz = c / (nx_ * ny_);
    for (int dz = cz > 0 ? -1 : 0; dz <= (cz + 1 < nz_ ? 1 : 0); ++dz) {
      for (int dy = cy > 0 ? -1 : 0; dy <= (cy + 1 < ny_ ? 1 : 0); ++dy) {
        for (int dx = cx > 0 ? -1 : 0; dx <= (cx + 1 < nx_ ? 1 : 0); ++dx) {
          const auto bin = static_cast<std::size_t>(c + dx + nx_ * (dy + ny_ * dz));
          for (int k = start_[bin]; k < start_[bin + 1]; ++k) visit(static_cast<int>(order_[static_cast<std::size_t>(k)]));
        }
      }
    }
  }

 private:
  int nx_ = 1, ny_ = 1, nz_ = 1;
  std::vector<std::int32_t> cell_of_;  // [n]
  std::vector<std::int32_t> start_;    // [n_cells + 1]
  std::vector<std::int32_t> order_;    // [n] points sorted by bin
};

}  // namespace regolab::dem
