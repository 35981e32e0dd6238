#include "worker/dem/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/simd/pack.h"

namespace regolab::dem {
namespace {

struct Range {
  double low, high;
};
Range range_of(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}
int bins(const Range& range, double cell) {
  constexpr double kMostBins = 128;  // along an axis: bounds memory when a grain strays
  const double n = std::floor((range.high - range.low) / cell);
  return n > 1 ? static_cast<int>(std::min(n, kMostBins)) : 1;  // not a number, after a run blew up: one bin
}
int bin_of(double value, const Range& range, int n) {
  const double at = (value - range.low) / (range.high - range.low) * n;
  return at > 0 ? static_cast<int>(std::min(at, n - 1.0)) : 0;  // not a number lands in bin 0
}

}  // namespace

void CellGrid::build(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                     std::span<const double> radius, double cell) {
  const std::size_t n = x.size();
  if (n == 0) return;
  const Range rx = range_of(x), ry = range_of(y), rz = range_of(z);
  nx_ = bins(rx, cell);
  ny_ = bins(ry, cell);
  nz_ = bins(rz, cell);
  const auto n_cells = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_);
  cell_of_.resize(n);
  start_.assign(n_cells + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const int c = bin_of(x[i], rx, nx_) + nx_ * (bin_of(y[i], ry, ny_) + ny_ * bin_of(z[i], rz, nz_));
    cell_of_[i] = c;
    ++start_[static_cast<std::size_t>(c) + 1];
  }
  for (std::size_t c = 0; c < n_cells; ++c) start_[c + 1] += start_[c];
  next_ = start_;
  for (auto* field : {&sorted_.at.x, &sorted_.at.y, &sorted_.at.z, &sorted_.radius}) field->resize(n + kMostLanes);
  sorted_.id.resize(n + kMostLanes);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(next_[static_cast<std::size_t>(cell_of_[i])]++);
    sorted_.at.x[at] = x[i], sorted_.at.y[at] = y[i], sorted_.at.z[at] = z[i], sorted_.radius[at] = radius[i];
    sorted_.id[at] = static_cast<std::int32_t>(i);
  }
}

}  // namespace regolab::dem
