#include "worker/dem/integrate.h"

#include "worker/dem/simd/records.h"

namespace regolab::dem {
namespace {

template <class P>
struct Quaternion {
  P w, x, y, z;
};
template <class P>
struct Rotation {  // space = R principal
  P xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

template <class P>
REGOLAB_INLINE Rotation<P> rotation(const Quaternion<P>& q) {
  return {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y - q.w * q.z),       2.0 * (q.x * q.z + q.w * q.y),
          2.0 * (q.x * q.y + q.w * q.z),       1.0 - 2.0 * (q.x * q.x + q.z * q.z), 2.0 * (q.y * q.z - q.w * q.x),
          2.0 * (q.x * q.z - q.w * q.y),       2.0 * (q.y * q.z + q.w * q.x),       1.0 - 2.0 * (q.x * q.x + q.y * q.y)};
}

/// w = R I^-1 R^T L, for the principal inverse inertia j.
template <class P>
REGOLAB_INLINE Triple<P> angular_velocity(const Rotation<P>& r, const Triple<P>& j, const Triple<P>& l) {
  const P px = j.x * (r.xx * l.x + r.yx * l.y + r.zx * l.z), py = j.y * (r.xy * l.x + r.yy * l.y + r.zy * l.z),
          pz = j.z * (r.xz * l.x + r.yz * l.y + r.zz * l.z);
  return {r.xx * px + r.xy * py + r.xz * pz, r.yx * px + r.yy * py + r.yz * pz, r.zx * px + r.zy * py + r.zz * pz};
}

/// q + k (w at), with w the angular velocity in space and `at` the turn where the rate is taken.
template <class P>
REGOLAB_INLINE Quaternion<P> turned(const Quaternion<P>& q, const Quaternion<P>& at, const Triple<P>& w, double k) {
  return {q.w + k * (-w.x * at.x - w.y * at.y - w.z * at.z), q.x + k * (w.x * at.w + w.y * at.z - w.z * at.y),
          q.y + k * (w.y * at.w + w.z * at.x - w.x * at.z), q.z + k * (w.z * at.w + w.x * at.y - w.y * at.x)};
}
template <class P>
REGOLAB_INLINE Quaternion<P> scaled(const Quaternion<P>& q, const P& s) { return {q.w * s, q.x * s, q.y * s, q.z * s}; }

/// The turn at mid-step. The rate is square to q, so the length grows to sqrt(1 + e): no root is needed to take that back.
template <class P>
REGOLAB_INLINE Quaternion<P> half_turned(const Quaternion<P>& q, const Triple<P>& w, double dt) {
  const double k = 0.25 * dt;
  const P e = k * k * dot(w, w);
  return scaled(turned(q, q, w, k), 1.0 + e * (0.375 * e - 0.5));
}

template <class P>
REGOLAB_INLINE Quaternion<P> fully_turned(const Quaternion<P>& q, const Quaternion<P>& half, const Triple<P>& w, double dt) {
  const Quaternion<P> end = turned(q, half, w, 0.5 * dt);
  return scaled(end, 1.0 / root(end.w * end.w + end.x * end.x + end.y * end.y + end.z * end.z));
}

/// To and from records `stride` doubles apart.
template <class P>
REGOLAB_INLINE void scatter(const Triple<P>& v, double* to, std::size_t stride, int lanes) {
  each_row(0, lanes, [=](int l, const Four& row) REGOLAB_INLINE_LAMBDA { store(row, to + static_cast<std::size_t>(l) * stride); },
           rows_of(v));
}
template <class P>
REGOLAB_INLINE Triple<P> strided(const double* from, std::size_t stride, int lanes) {
  return gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return from + static_cast<std::size_t>(l < lanes ? l : 0) * stride; }).xyz;
}
template <class P>
REGOLAB_INLINE Triple<P> load3(const double* x, const double* y, const double* z, std::size_t i, int lanes) {
  return {load_lanes<P>(x + i, lanes), load_lanes<P>(y + i, lanes), load_lanes<P>(z + i, lanes)};
}
template <class P>
REGOLAB_INLINE void store3(const Triple<P>& v, double* x, double* y, double* z, std::size_t i, int lanes) {
  store_lanes(v.x, x + i, lanes), store_lanes(v.y, y + i, lanes), store_lanes(v.z, z + i, lanes);
}

struct Arrays {
  explicit Arrays(Bodies& b, Margins& m)
      : x(b.x.data()), y(b.y.data()), z(b.z.data()), vx(b.vx.data()), vy(b.vy.data()), vz(b.vz.data()), qw(b.qw.data()),
        qx(b.qx.data()), qy(b.qy.data()), qz(b.qz.data()), lx(b.lx.data()), ly(b.ly.data()), lz(b.lz.data()), wx(b.wx.data()),
        wy(b.wy.data()), wz(b.wz.data()), im(b.inverse_mass.data()), jx(b.inverse_ix.data()), jy(b.inverse_iy.data()),
        jz(b.inverse_iz.data()), swing(b.swing.data()), margin(m.margin.data()), path(m.path.data()), load(b.load.data()),
        motion(b.motion.data()), placing(b.placing.data()) {}
  double *x, *y, *z, *vx, *vy, *vz, *qw, *qx, *qy, *qz, *lx, *ly, *lz, *wx, *wy, *wz;
  const double *im, *jx, *jy, *jz, *swing, *margin;
  double* path;
  Load* load;
  Motion* motion;
  Placing* placing;
};

constexpr std::size_t kMotionStride = sizeof(Motion) / sizeof(double), kPlacingStride = sizeof(Placing) / sizeof(double),
                      kLoadStride = sizeof(Load) / sizeof(double);

/// Velocity and position, before and after.
template <class P>
struct Flight {
  Triple<P> v, x, force, x_before;
};

template <class P>
REGOLAB_INLINE Flight<P> translate(const Kick& kick, std::size_t i, int lanes, const Arrays& a) {
  const P im = load_lanes<P>(a.im + i, lanes);
  Flight<P> fly;
  fly.force = strided<P>(&a.load[i].fx, kLoadStride, lanes);
  fly.x_before = load3<P>(a.x, a.y, a.z, i, lanes);
  Triple<P> push = im * fly.force;
  push.z = push.z - select(im > 0.0, pack_of<P>(kick.gravity), P{});
  fly.v = kick.keep * load3<P>(a.vx, a.vy, a.vz, i, lanes) + kick.dt * push;
  fly.x = fly.x_before + kick.dt * fly.v;
  store3(fly.v, a.vx, a.vy, a.vz, i, lanes);
  store3(fly.x, a.x, a.y, a.z, i, lanes);
  scatter(fly.x, a.placing[i].centre.v, kPlacingStride, lanes);
  return fly;
}

/// Angular momentum after the kick; the torque is taken from the origin to the centre of mass.
template <class P>
REGOLAB_INLINE Triple<P> spun_up(const Kick& kick, std::size_t i, int lanes, const Flight<P>& fly, const P& j, const Arrays& a) {
  const P is_free = select(j > 0.0, pack_of<P>(kick.dt), P{});
  const Triple<P> torque = strided<P>(&a.load[i].tx, kLoadStride, lanes) - cross(fly.x_before, fly.force);
  const Triple<P> l = kick.keep * load3<P>(a.lx, a.ly, a.lz, i, lanes) + is_free * torque;
  store3(l, a.lx, a.ly, a.lz, i, lanes);
  return l;
}

template <class P>
REGOLAB_INLINE Triple<P> turn(const Kick& kick, std::size_t i, int lanes, const Flight<P>& fly, const Arrays& a) {
  const Triple<P> j = load3<P>(a.jx, a.jy, a.jz, i, lanes), l = spun_up(kick, i, lanes, fly, j.x, a);
  Quaternion<P> q{load_lanes<P>(a.qw + i, lanes), load_lanes<P>(a.qx + i, lanes), load_lanes<P>(a.qy + i, lanes),
                  load_lanes<P>(a.qz + i, lanes)};
  const Quaternion<P> half = half_turned(q, angular_velocity(rotation(q), j, l), kick.dt);
  const Triple<P> w = angular_velocity(rotation(half), j, l);
  q = fully_turned(q, half, w, kick.dt);
  store_lanes(q.w, a.qw + i, lanes);
  store3<P>({q.x, q.y, q.z}, a.qx, a.qy, a.qz, i, lanes);
  const Rotation<P> r = rotation(q);
  scatter<P>({r.xx, r.yx, r.zx}, a.placing[i].column[0].v, kPlacingStride, lanes);
  scatter<P>({r.xy, r.yy, r.zy}, a.placing[i].column[1].v, kPlacingStride, lanes);
  scatter<P>({r.xz, r.yz, r.zz}, a.placing[i].column[2].v, kPlacingStride, lanes);
  return w;
}

/// Clusters of one sphere: no turn shows, and the inverse inertia has no axes.
template <class P>
REGOLAB_INLINE Triple<P> spin_only(const Kick& kick, std::size_t i, int lanes, const Flight<P>& fly, const Arrays& a) {
  const P j = load_lanes<P>(a.jx + i, lanes);
  return j * spun_up(kick, i, lanes, fly, j, a);
}

/// One block of clusters; which lanes left their margin.
template <class P, bool kTurns>
REGOLAB_INLINE auto advance(const Kick& kick, std::size_t i, int lanes, const Arrays& a) {
  const Flight<P> fly = translate<P>(kick, i, lanes, a);
  const Triple<P> w = kTurns ? turn(kick, i, lanes, fly, a) : spin_only(kick, i, lanes, fly, a);
  store3(w, a.wx, a.wy, a.wz, i, lanes);
  scatter(fly.v - cross(w, fly.x), a.motion[i].origin_velocity.v, kMotionStride, lanes);
  scatter(w, a.motion[i].spin.v, kMotionStride, lanes);
  for (int l = 0; l < lanes; ++l) a.load[i + static_cast<std::size_t>(l)] = Load{};
  const P speed = root(fastest_point2(dot(fly.v, fly.v), dot(w, w), load_lanes<P>(a.swing + i, lanes)));
  const P path = load_lanes<P>(a.path + i, lanes) + kick.dt * speed;
  store_lanes(path, a.path + i, lanes);
  return path > load_lanes<P>(a.margin + i, lanes);
}

template <class P, bool kTurns>
REGOLAB_INLINE bool advance_all(const Kick& kick, Stretch stretch, const Arrays& arrays) {
  auto left = P{} > P{};
  std::size_t i = stretch.begin;
  for (; i + kLanes<P> <= stretch.end; i += kLanes<P>) left |= advance<P, kTurns>(kick, i, kLanes<P>, arrays);
  if (i < stretch.end) left |= advance<P, kTurns>(kick, i, static_cast<int>(stretch.end - i), arrays);
  return any(left);
}

template <class P>
REGOLAB_INLINE bool kick_and_drift_with(const Kick& shared_kick, Stretch stretch, Bodies& bodies, Margins& margins) {
  const Kick kick = shared_kick;  // a copy: stores below cannot alias it
  const Arrays arrays(bodies, margins);
  return margins.anything_swings ? advance_all<P, true>(kick, stretch, arrays) : advance_all<P, false>(kick, stretch, arrays);
}

}  // namespace

REGOLAB_HOT(bool, kick_and_drift, (const Kick& kick, Stretch stretch, Bodies& bodies, Margins& margins),
            (kick, stretch, bodies, margins))

}  // namespace regolab::dem
