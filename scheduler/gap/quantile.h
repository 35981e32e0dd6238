/// A quantile of numbers, by counting.
#pragma once
#include <algorithm>
#include <vector>

namespace regolab::gap {

/// The value below which a share of them lies. REQUIRES: v is not empty.
inline double quantile(std::vector<double> v, double share) {
  std::ranges::sort(v);
  return v[std::min(v.size() - 1, static_cast<std::size_t>(share * static_cast<double>(v.size())))];
}

}  // namespace regolab::gap
