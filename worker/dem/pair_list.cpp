#include "worker/dem/pair_list.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/simd/pack.h"

namespace regolab::dem {
namespace {

/// Which of kLanes points come within `reach` + their own radius of a place; the points' arrays have room for a whole pack.
template <class P>
REGOLAB_INLINE auto within(double px, double py, double pz, double reach, const Centres& at, const std::vector<double>& radius,
                           std::size_t k) {
  const P dx = load<P>(at.x.data() + k) - px, dy = load<P>(at.y.data() + k) - py, dz = load<P>(at.z.data() + k) - pz;
  const P limit = load<P>(radius.data() + k) + reach;
  return dx * dx + dy * dy + dz * dz < limit * limit;
}

/// visit(k) for each such point of [begin, end), in order.
template <class P, class Visit>
REGOLAB_INLINE void each_within(double x, double y, double z, double reach, const Centres& at, const std::vector<double>& radius,
                                std::size_t begin, std::size_t end, Visit visit) {
  for (std::size_t k = begin; k < end; k += static_cast<std::size_t>(kLanes<P>)) {
    const auto found = within<P>(x, y, z, reach, at, radius, k);
    if (!any(found)) continue;
    const auto lanes = static_cast<int>(std::min<std::size_t>(end - k, kLanes<P>));
    for (int l = 0; l < lanes; ++l) {
      if (found[l]) visit(k + static_cast<std::size_t>(l));
    }
  }
}

/// Later clusters whose bounding balls, allowances included, meet cluster i's (`reach`), in index order.
template <class P>
REGOLAB_INLINE void near_clusters(const Bodies& b, const CellGrid& grid, double reach, int i, std::vector<std::int32_t>& found) {
  found.clear();
  const auto p = static_cast<std::size_t>(i);
  const auto& points = grid.points();
  grid.rows_around(i, [&](std::size_t begin, std::size_t end) REGOLAB_INLINE_LAMBDA {
    each_within<P>(b.x[p], b.y[p], b.z[p], reach, points.at, points.radius, begin, end, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
      const int j = points.id[k];
      if (j <= i || b.gone[static_cast<std::size_t>(j)] || (b.is_fixed(i) && b.is_fixed(j))) return;
      found.push_back(j);
    });
  });
  std::sort(found.begin(), found.end());
}

/// Where the search takes the spheres to be, and how large, allowances included: a tumbling cluster's all fill its bounding ball.
void take_places(const Bodies& b, const Spheres& spheres, const Centres& centres, double time, PairList& pairs) {
  const std::size_t n = centres.x.size();
  auto& s = pairs.scratch;
  s.at = centres;
  s.radius = spheres.radius;
  for (auto* field : {&s.at.x, &s.at.y, &s.at.z, &s.radius}) field->resize(n + kMostLanes);
  pairs.swing = b.swing;
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    const double w2 = b.wx[i] * b.wx[i] + b.wy[i] * b.wy[i] + b.wz[i] * b.wz[i];
    const double allowance = pairs.allowance[i], turn = time * std::sqrt(w2) * b.swing[i];
    const bool tumbles = turn > 0.5 * allowance;
    if (tumbles) pairs.swing[i] = 0;
    for (auto k = static_cast<std::size_t>(b.first_sphere[i]); k < static_cast<std::size_t>(b.first_sphere[i + 1]); ++k) {
      if (tumbles) s.at.x[k] = b.x[i], s.at.y[k] = b.y[i], s.at.z[k] = b.z[i];
      s.radius[k] = (tumbles ? b.reach[i] : spheres.radius[k]) + allowance + 0.5 * pairs.attraction;
    }
  }
}

template <class P>
REGOLAB_INLINE void list_pairs_with(const Bodies& bodies, const Spheres& spheres, PairList& pairs) {
  auto& s = pairs.scratch;
  for (int i = 0; i < bodies.count(); ++i) {
    const auto p = static_cast<std::size_t>(i);
    if (bodies.gone[p]) continue;
    near_clusters<P>(bodies, s.grid, bodies.reach[p] + pairs.allowance[p] + 0.5 * pairs.attraction, i, s.others);
    for (auto a = static_cast<std::size_t>(bodies.first_sphere[p]); a < static_cast<std::size_t>(bodies.first_sphere[p + 1]); ++a) {
      for (const std::int32_t other : s.others) {
        const auto q = static_cast<std::size_t>(other);
        each_within<P>(s.at.x[a], s.at.y[a], s.at.z[a], s.radius[a], s.at, s.radius,
                       static_cast<std::size_t>(bodies.first_sphere[q]), static_cast<std::size_t>(bodies.first_sphere[q + 1]),
                       [&](std::size_t b) REGOLAB_INLINE_LAMBDA {
                         pairs.a.push_back(static_cast<std::int32_t>(a));
                         pairs.b.push_back(static_cast<std::int32_t>(b));
                         pairs.sum_of_radii.push_back(spheres.radius[a] + spheres.radius[b]);
                       });
      }
    }
  }
}

}  // namespace

REGOLAB_HOT(void, list_pairs, (const Bodies& bodies, const Spheres& spheres, PairList& pairs), (bodies, spheres, pairs))

void build_pairs(const Bodies& bodies, const Spheres& spheres, const Centres& centres, double time, PairList& pairs) {
  pairs.a.clear();
  pairs.b.clear();
  pairs.sum_of_radii.clear();
  take_places(bodies, spheres, centres, time, pairs);
  auto& reach = pairs.scratch.reach;
  reach.resize(bodies.x.size());
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = bodies.reach[i] + pairs.allowance[i] + 0.5 * pairs.attraction;
  pairs.scratch.grid.build(bodies.x, bodies.y, bodies.z, reach, 2 * *std::max_element(reach.begin(), reach.end()));
  list_pairs(bodies, spheres, pairs);
  pairs.at_build = {bodies.x, bodies.y, bodies.z, bodies.qw, bodies.qx, bodies.qy, bodies.qz};
}

bool moved_beyond(const PairList& pairs, const Bodies& bodies, const Margins& margins) {
  // |dq| = 2 sin(angle/4), so angle < 2.1 |dq| up to 70 degrees; a larger turn is far beyond any skin.
  constexpr double kAnglePerQuaternion = 2.1;
  const std::size_t n = bodies.x.size();
  const Poses& since = pairs.at_build;
  if (since.x.size() != n) return true;
  const double *x = bodies.x.data(), *y = bodies.y.data(), *z = bodies.z.data(), *swing = pairs.swing.data();
  const double *qw = bodies.qw.data(), *qx = bodies.qx.data(), *qy = bodies.qy.data(), *qz = bodies.qz.data();
  const double *x0 = since.x.data(), *y0 = since.y.data(), *z0 = since.z.data(), *margin = margins.margin.data();
  const double* allowance = pairs.allowance.data();
  const double *w0 = since.qw.data(), *a0 = since.qx.data(), *b0 = since.qy.data(), *c0 = since.qz.data();
  int beyond = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i] - x0[i], dy = y[i] - y0[i], dz = z[i] - z0[i];
    const double dw = qw[i] - w0[i], da = qx[i] - a0[i], db = qy[i] - b0[i], dc = qz[i] - c0[i];
    const double shift = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double turn = std::sqrt(dw * dw + da * da + db * db + dc * dc);
    beyond |= shift + kAnglePerQuaternion * swing[i] * turn + margin[i] > allowance[i] ? 1 : 0;
  }
  return beyond != 0;
}

}  // namespace regolab::dem
