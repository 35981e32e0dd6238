#include "worker/dem/pair_list.h"

#include <algorithm>
#include <cmath>

namespace regolab::dem {
namespace {

struct Gap {
  const Spheres& s;
  double skin;
  bool near(std::size_t i, double x, double y, double z, double radius) const {
    const double dx = s.x[i] - x, dy = s.y[i] - y, dz = s.z[i] - z;
    const double limit = s.radius[i] + radius + skin;
    return dx * dx + dy * dy + dz * dz < limit * limit;
  }
};

/// Later clusters whose bounding balls come within the skin of cluster i's, in index order.
void near_clusters(const Bodies& b, const CellGrid& grid, double skin, int i, std::vector<int>& found) {
  found.clear();
  const auto p = static_cast<std::size_t>(i);
  grid.around(i, [&](int j) {
    const auto q = static_cast<std::size_t>(j);
    if (j <= i || b.gone[q] || (b.is_fixed(i) && b.is_fixed(j))) return;
    const double dx = b.x[q] - b.x[p], dy = b.y[q] - b.y[p], dz = b.z[q] - b.z[p];
    const double limit = b.reach[p] + b.reach[q] + skin;
    if (dx * dx + dy * dy + dz * dz < limit * limit) found.push_back(j);
  });
  std::sort(found.begin(), found.end());
}

}  // namespace

void History::assign(std::size_t slots) {
  sx.assign(slots, 0.0);
  sy.assign(slots, 0.0);
  sz.assign(slots, 0.0);
  touched.assign(slots, -2);
}

void carry_over(const ListKeys& old_keys, const History& old, const ListKeys& fresh_keys, std::int64_t step, History& fresh) {
  std::size_t k = 0;
  for (std::size_t n = 0; n < fresh_keys.first.size(); ++n) {
    const auto first = fresh_keys.first[n], second = fresh_keys.second[n];
    while (k < old_keys.first.size() &&
           (old_keys.first[k] < first || (old_keys.first[k] == first && old_keys.second[k] < second))) {
      ++k;
    }
    if (k == old_keys.first.size()) return;
    if (old_keys.first[k] != first || old_keys.second[k] != second || old.touched[k] + 1 < step) continue;
    fresh.sx[n] = old.sx[k];
    fresh.sy[n] = old.sy[k];
    fresh.sz[n] = old.sz[k];
    fresh.touched[n] = old.touched[k];
  }
}

void build_pairs(const Bodies& bodies, const Spheres& spheres, double skin, std::int64_t step, CellGrid& grid, PairList& pairs) {
  PairList fresh;
  fresh.a.reserve(pairs.a.size() + pairs.a.size() / 4);
  fresh.b.reserve(fresh.a.capacity());
  const double cell = 2 * *std::max_element(bodies.reach.begin(), bodies.reach.end()) + skin;
  grid.build(bodies.x, bodies.y, bodies.z, cell);
  const Gap gap{spheres, skin};
  std::vector<int> others;
  for (int i = 0; i < bodies.count(); ++i) {
    const auto p = static_cast<std::size_t>(i);
    if (bodies.gone[p]) continue;
    near_clusters(bodies, grid, skin, i, others);
    for (auto s = bodies.first_sphere[p]; s < bodies.first_sphere[p + 1]; ++s) {
      const auto a = static_cast<std::size_t>(s);
      for (const int other : others) {
        const auto q = static_cast<std::size_t>(other);
        if (!gap.near(a, bodies.x[q], bodies.y[q], bodies.z[q], bodies.reach[q])) continue;
        for (auto t = bodies.first_sphere[q]; t < bodies.first_sphere[q + 1]; ++t) {
          const auto b = static_cast<std::size_t>(t);
          if (!gap.near(a, spheres.x[b], spheres.y[b], spheres.z[b], spheres.radius[b])) continue;
          fresh.a.push_back(s);
          fresh.b.push_back(t);
        }
      }
    }
  }
  const std::size_t n = fresh.a.size();
  fresh.sum_of_radii.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    fresh.sum_of_radii[k] =
        spheres.radius[static_cast<std::size_t>(fresh.a[k])] + spheres.radius[static_cast<std::size_t>(fresh.b[k])];
  }
  fresh.history.assign(n);
  carry_over({pairs.a, pairs.b}, pairs.history, {fresh.a, fresh.b}, step, fresh.history);
  pairs = std::move(fresh);
}

}  // namespace regolab::dem
