/// Bins of points in a box, for neighbour search. Deterministic: within a bin, points stand in index order.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "worker/dem/bodies.h"

namespace regolab::dem {

class CellGrid {
 public:
  /// Bins at least `cell` wide. A far stray costs bins only up to a limit.
  void build(std::span<const double> x, std::span<const double> y, std::span<const double> z, std::span<const double> radius,
             double cell);

  /// Points in the order of their bins, with room for a whole pack past the last: a row of bins along x is one stretch of these.
  struct Points {
    Centres at;                    // [n]
    std::vector<double> radius;    // [n]
    std::vector<std::int32_t> id;  // [n]
  };
  const Points& points() const { return sorted_; }

  /// Calls visit(begin, end), stretches of points(), for the 9 rows of 3 bins around point i (i itself included).
  template <class Visit>
  void rows_around(int i, Visit visit) const {
    const auto c = cell_of_[static_cast<std::size_t>(i)];
    const int cx = c % nx_, cy = (c / nx_) % ny_, cz = c / (nx_ * ny_);
    const int left = cx > 0 ? -1 : 0, right = cx + 1 < nx_ ? 1 : 0;
    for (int dz = cz > 0 ? -1 : 0; dz <= (cz + 1 < nz_ ? 1 : 0); ++dz) {
      for (int dy = cy > 0 ? -1 : 0; dy <= (cy + 1 < ny_ ? 1 : 0); ++dy) {
        const int row = c + nx_ * (dy + ny_ * dz);
        visit(static_cast<std::size_t>(start_[static_cast<std::size_t>(row + left)]),
              static_cast<std::size_t>(start_[static_cast<std::size_t>(row + right + 1)]));
      }
    }
  }

 private:
  int nx_ = 1, ny_ = 1, nz_ = 1;
  std::vector<std::int32_t> cell_of_;  // [n]
  std::vector<std::int32_t> start_, next_;  // [n_cells + 1]
  Points sorted_;
};

}  // namespace regolab::dem
