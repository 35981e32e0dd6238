#include "worker/dem/near_list.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/simd/pack.h"

namespace regolab::dem {
namespace {

/// Room for n and a pack more; never shrinks, so that most refreshes allocate nothing.
template <class... Vectors>
void make_room(std::size_t n, Vectors&... vectors) {
  ((vectors.size() < n + kMostLanes ? vectors.resize(n + n / 4 + 64) : void()), ...);
}

void relax(Slots& s) {
  make_room(s.count, s.root_mass, s.sx, s.sy, s.sz, s.fx, s.fy, s.fz, s.ball_a);
  for (auto* zero : {&s.sx, &s.sy, &s.sz, &s.fx, &s.fy, &s.fz}) std::fill_n(zero->begin(), s.count, 0.0);
  if (!s.rolls) return;
  make_room(s.count, s.rx, s.ry, s.rz);
  for (auto* zero : {&s.rx, &s.ry, &s.rz}) std::fill_n(zero->begin(), s.count, 0.0);
}

/// The indices of a whole pack past the count repeat the last.
template <class... Indices>
void pad(std::size_t count, Indices&... indices) {
  if (count == 0) return;
  const auto from = static_cast<std::ptrdiff_t>(count);
  (std::fill_n(indices.begin() + from, kMostLanes, indices[count - 1]), ...);
}

}  // namespace

void make_room_for_pairs(std::size_t listed, Slots& slots) {
  make_room(listed, slots.first, slots.second, slots.body_a, slots.body_b);
}

std::size_t list_near_pairs(const PairList& pairs, const Spheres& spheres, const Centres& at, const Margins& margins, Stretch stretch,
                            Slots& slots) {
  const std::int32_t *pair_a = pairs.a.data(), *pair_b = pairs.b.data(), *body = spheres.body.data();
  const double *x = at.x.data(), *y = at.y.data(), *z = at.z.data(), *reach = pairs.sum_of_radii.data();
  const double* margin = margins.margin.data();
  const double attraction = margins.attraction;
  std::int32_t *first = slots.first.data(), *second = slots.second.data(), *body_a = slots.body_a.data(), *body_b = slots.body_b.data();
  std::size_t found = stretch.begin;
  for (std::size_t p = stretch.begin; p < stretch.end; ++p) {
    const std::int32_t a = pair_a[p], b = pair_b[p], i = body[a], j = body[b];
    const double dx = x[a] - x[b], dy = y[a] - y[b], dz = z[a] - z[b];
    const double limit = reach[p] + margin[i] + margin[j] + attraction;
    first[found] = a, second[found] = b;
    body_a[found] = i, body_b[found] = j;
    found += dx * dx + dy * dy + dz * dz < limit * limit;  // no branch: which pairs are near is hard to foresee
  }
  return found - stretch.begin;
}

void append_pairs(std::size_t begin, std::size_t more, Slots& slots) {
  for (auto* field : {&slots.first, &slots.second, &slots.body_a, &slots.body_b}) {
    const auto from = field->begin() + static_cast<std::ptrdiff_t>(begin);
    std::copy(from, from + static_cast<std::ptrdiff_t>(more), field->begin() + static_cast<std::ptrdiff_t>(slots.count));
  }
  slots.count += more;
}

void list_near_walls(const Bodies& bodies, const Spheres& spheres, const Centres& at, const Walls& walls, const Margins& margins,
                     double wall_margin, Slots& slots) {
  slots.count = 0;
  for (std::size_t i = 0; i < bodies.x.size(); ++i) {
    if (bodies.gone[i] || bodies.inverse_mass[i] == 0.0) continue;
    const double margin = margins.margin[i] + wall_margin;
    std::array<int, kWallIds> near{};
    std::size_t n_near = 0;
    for (int id = 0; id < kWallIds; ++id) {
      if (!walls[id].present) continue;
      if (wall_distance(walls, id, {bodies.x[i], bodies.y[i], bodies.z[i]}).distance - bodies.reach[i] <= margin) near[n_near++] = id;
    }
    if (n_near == 0) continue;
    for (auto s = bodies.first_sphere[i]; s < bodies.first_sphere[i + 1]; ++s) {
      const auto k = static_cast<std::size_t>(s);
      for (std::size_t w = 0; w < n_near; ++w) {
        if (wall_distance(walls, near[w], {at.x[k], at.y[k], at.z[k]}).distance - spheres.radius[k] > margin) continue;
        make_room(slots.count + 1, slots.first, slots.second, slots.body_a);
        slots.first[slots.count] = s;
        slots.second[slots.count] = near[w];
        slots.body_a[slots.count++] = static_cast<std::int32_t>(i);
      }
    }
  }
}

void fill_pair_slots(const Bodies& bodies, Slots& s) {
  relax(s);
  make_room(s.count, s.ball_b, s.onto_b);
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto i = static_cast<std::size_t>(s.body_a[k]), j = static_cast<std::size_t>(s.body_b[k]);
    s.root_mass[k] = 1.0 / std::sqrt(bodies.inverse_mass[i] + bodies.inverse_mass[j]);
  }
}

void fill_wall_slots(const Bodies& bodies, Slots& s) {
  relax(s);
  make_room(s.count, s.normal, s.shear);
  std::fill_n(s.normal.begin(), s.count, kApart);
  for (std::size_t k = 0; k < s.count; ++k) {
    s.root_mass[k] = std::sqrt(bodies.mass[static_cast<std::size_t>(s.body_a[k])]);
  }
}

void collect_balls(const Spheres& spheres, Slots& pairs, Slots& walls, Balls& balls) {
  constexpr std::int32_t kNamed = 1;
  const auto n = static_cast<std::size_t>(spheres.count());
  auto& of = balls.of_sphere;
  of.assign(n, 0);
  for (std::size_t k = 0; k < pairs.count; ++k) {
    of[static_cast<std::size_t>(pairs.first[k])] = kNamed;
    of[static_cast<std::size_t>(pairs.second[k])] = kNamed;
  }
  for (std::size_t k = 0; k < walls.count; ++k) of[static_cast<std::size_t>(walls.first[k])] = kNamed;
  balls.body.clear(), balls.offset.clear();
  for (std::size_t s = 0; s < n; ++s) {
    if (of[s] != kNamed) continue;
    of[s] = static_cast<std::int32_t>(balls.body.size());
    balls.body.push_back(spheres.body[s]);
    balls.offset.push_back({spheres.ox[s], spheres.oy[s], spheres.oz[s], spheres.radius[s]});
  }
  make_room(balls.body.size(), balls.at);
  for (std::size_t k = 0; k < pairs.count; ++k) {
    pairs.ball_a[k] = of[static_cast<std::size_t>(pairs.first[k])];
    pairs.ball_b[k] = of[static_cast<std::size_t>(pairs.second[k])];
  }
  for (std::size_t k = 0; k < walls.count; ++k) walls.ball_a[k] = of[static_cast<std::size_t>(walls.first[k])];
  pad(pairs.count, pairs.ball_a, pairs.ball_b, pairs.body_a, pairs.body_b);
  pad(walls.count, walls.ball_a, walls.body_a, walls.second);
}

namespace {

template <class>
REGOLAB_INLINE void place_balls_with(const Bodies& bodies, Stretch stretch, Balls& balls) {
  const std::int32_t* body = balls.body.data();
  const Quad* offset = balls.offset.data();
  Quad* at = balls.at.data();
  const Placing* placing = bodies.placing.data();
  for (std::size_t k = stretch.begin; k < stretch.end; ++k) {
    const auto& [centre, column] = placing[body[k]];
    const Four o = load<Four>(offset[k].v);
    const Four arm = load<Four>(column[0].v) * o[0] + load<Four>(column[1].v) * o[1] + load<Four>(column[2].v) * o[2];
    const Four place = load<Four>(centre.v) + arm;
    store(__builtin_shufflevector(place, o, 0, 1, 2, 7), at[k].v);
  }
}

}  // namespace

REGOLAB_HOT(void, place_balls, (const Bodies& bodies, Stretch stretch, Balls& balls), (bodies, stretch, balls))

void take_springs(const Slots& slots, Springs& springs) {
  springs.clear();
  for (std::size_t k = 0; k < slots.count; ++k) {
    const bool slid = slots.sx[k] != 0.0 || slots.sy[k] != 0.0 || slots.sz[k] != 0.0;
    const bool rolled = slots.rolls && (slots.rx[k] != 0.0 || slots.ry[k] != 0.0 || slots.rz[k] != 0.0);
    if (!slid && !rolled) continue;
    springs.push(slots.first[k], slots.second[k], slots.sx[k], slots.sy[k], slots.sz[k]);
    if (slots.rolls) springs.rx.push_back(slots.rx[k]), springs.ry.push_back(slots.ry[k]), springs.rz.push_back(slots.rz[k]);
  }
}

void give_springs(const Springs& springs, Slots& slots) {
  const bool rolled = slots.rolls && springs.rx.size() == springs.size();
  std::size_t k = 0;
  for (std::size_t n = 0; n < springs.size(); ++n) {
    const auto before = [&] {
      return slots.first[k] < springs.first[n] || (slots.first[k] == springs.first[n] && slots.second[k] < springs.second[n]);
    };
    while (k < slots.count && before()) ++k;
    if (k == slots.count) break;
    if (slots.first[k] != springs.first[n] || slots.second[k] != springs.second[n]) continue;
    slots.sx[k] = springs.sx[n];
    slots.sy[k] = springs.sy[n];
    slots.sz[k] = springs.sz[n];
    if (!rolled) continue;
    slots.rx[k] = springs.rx[n];
    slots.ry[k] = springs.ry[n];
    slots.rz[k] = springs.rz[n];
  }
  slots.hold_springs = true;
}

}  // namespace regolab::dem
