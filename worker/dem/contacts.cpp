#include "worker/dem/contacts.h"

#include <cmath>

#include "worker/dem/hot.h"

namespace regolab::dem {
namespace {

void push(Bodies& b, std::size_t i, double fx, double fy, double fz, double ax, double ay, double az) {
  b.fx[i] += fx;
  b.fy[i] += fy;
  b.fz[i] += fz;
  b.tx[i] += ay * fz - az * fy;
  b.ty[i] += az * fx - ax * fz;
  b.tz[i] += ax * fy - ay * fx;
}

}  // namespace

void Contacts::reserve_slots(std::size_t n) {
  if (slot.size() >= n) return;
  const std::size_t room = n + n / 4;
  for (auto* ints : {&slot, &body_a, &body_b}) ints->resize(room);
  for (auto* reals : {&nx, &ny, &nz, &overlap, &ax, &ay, &az, &bx, &by, &bz, &vx, &vy, &vz, &sx, &sy, &sz, &friction, &root_mass,
                      &fx, &fy, &fz}) {
    reals->resize(room);
  }
}

std::size_t Contacts::count() const {
  std::size_t n = 0;
  for (const Segment& s : segments) n += s.count;
  return n;
}

void cut_segments(std::size_t n, int threads, Contacts& contacts) {
  contacts.reserve_slots(n);
  const auto parts = static_cast<std::size_t>(threads);
  contacts.segments.resize(parts);
  for (std::size_t t = 0; t < parts; ++t) contacts.segments[t] = {n * t / parts, n * (t + 1) / parts, 0};
}

namespace {

/// Which listed pairs touch: their list indices, in order, to the front of the segment.
std::size_t find_touching(const Spheres& s, const PairList& pairs, std::size_t begin, std::size_t end, std::int32_t* slot) {
  std::size_t found = 0;
  for (std::size_t p = begin; p < end; ++p) {
    const auto a = static_cast<std::size_t>(pairs.a[p]), b = static_cast<std::size_t>(pairs.b[p]);
    const double dx = s.x[a] - s.x[b], dy = s.y[a] - s.y[b], dz = s.z[a] - s.z[b];
    const double distance2 = dx * dx + dy * dy + dz * dz, reach = pairs.sum_of_radii[p];
    slot[found] = static_cast<std::int32_t>(p);
    found += distance2 < reach * reach && distance2 > 0.0;  // no branch: which pairs touch is hard to foresee
  }
  return found;
}

/// Springs of contacts that touched the step before; others start relaxed.
void take_history(const History& history, std::int64_t step, Contacts& c, std::size_t begin, std::size_t end) {
  for (std::size_t k = begin; k < end; ++k) {
    const auto h = static_cast<std::size_t>(c.slot[k]);
    const double carried = history.touched[h] + 1 >= step ? 1.0 : 0.0;
    c.sx[k] = carried * history.sx[h];
    c.sy[k] = carried * history.sy[h];
    c.sz[k] = carried * history.sz[h];
  }
}

}  // namespace

REGOLAB_HOT void gather_pairs(const Bodies& bodies, const Spheres& spheres, const PairList& pairs, const LinearLaw& law,
                              std::int64_t step, Contacts& c, Contacts::Segment& segment) {
  std::int32_t* slot = c.slot.data();
  segment.count = find_touching(spheres, pairs, segment.begin, segment.end, slot + segment.begin);
  const std::size_t end = segment.begin + segment.count;
  const std::int32_t *pair_a = pairs.a.data(), *pair_b = pairs.b.data(), *body = spheres.body.data();
  const double *x = spheres.x.data(), *y = spheres.y.data(), *z = spheres.z.data(), *radius = spheres.radius.data();
  const double *bx = bodies.x.data(), *by = bodies.y.data(), *bz = bodies.z.data();
  const double *vx = bodies.vx.data(), *vy = bodies.vy.data(), *vz = bodies.vz.data();
  const double *wx = bodies.wx.data(), *wy = bodies.wy.data(), *wz = bodies.wz.data();
  std::int32_t *body_a = c.body_a.data(), *body_b = c.body_b.data();
  double *nx = c.nx.data(), *ny = c.ny.data(), *nz = c.nz.data(), *overlap = c.overlap.data();
  double *ax = c.ax.data(), *ay = c.ay.data(), *az = c.az.data(), *cx = c.bx.data(), *cy = c.by.data(), *cz = c.bz.data();
  double *ux = c.vx.data(), *uy = c.vy.data(), *uz = c.vz.data();
#pragma GCC ivdep
  for (std::size_t k = segment.begin; k < end; ++k) {
    const std::int32_t a = pair_a[slot[k]], b = pair_b[slot[k]], i = body[a], j = body[b];
    const double dx = x[a] - x[b], dy = y[a] - y[b], dz = z[a] - z[b];
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double n0 = dx / distance, n1 = dy / distance, n2 = dz / distance;
    const double depth = radius[a] + radius[b] - distance;
    const double to_a = radius[a] - 0.5 * depth, to_b = radius[b] - 0.5 * depth;  // contact point: middle of the overlap
    const double a0 = x[a] - bx[i] - to_a * n0, a1 = y[a] - by[i] - to_a * n1, a2 = z[a] - bz[i] - to_a * n2;
    const double b0 = x[b] - bx[j] + to_b * n0, b1 = y[b] - by[j] + to_b * n1, b2 = z[b] - bz[j] + to_b * n2;
    body_a[k] = i, body_b[k] = j;
    nx[k] = n0, ny[k] = n1, nz[k] = n2, overlap[k] = depth;
    ax[k] = a0, ay[k] = a1, az[k] = a2, cx[k] = b0, cy[k] = b1, cz[k] = b2;
    ux[k] = vx[i] + (wy[i] * a2 - wz[i] * a1) - (vx[j] + (wy[j] * b2 - wz[j] * b1));
    uy[k] = vy[i] + (wz[i] * a0 - wx[i] * a2) - (vy[j] + (wz[j] * b0 - wx[j] * b2));
    uz[k] = vz[i] + (wx[i] * a1 - wy[i] * a0) - (vz[j] + (wx[j] * b1 - wy[j] * b0));
  }
  for (std::size_t k = segment.begin; k < end; ++k) {
    const auto i = static_cast<std::size_t>(body_a[k]), j = static_cast<std::size_t>(body_b[k]);
    c.friction[k] = law.friction;
    c.root_mass[k] = law.damping_is_ratio ? 1.0 / std::sqrt(bodies.inverse_mass[i] + bodies.inverse_mass[j]) : 1.0;
  }
  take_history(pairs.history, step, c, segment.begin, end);
}

void gather_walls(const Bodies& bodies, const Spheres& s, const Walls& walls, const LinearLaw& law, std::int64_t step,
                  Contacts& c, Contacts::Segment& segment) {
  std::size_t k = segment.begin;
  for (std::size_t p = segment.begin; p < segment.end; ++p) {
    const auto a = static_cast<std::size_t>(walls.sphere[p]);
    const int id = walls.id[p];
    const WallGap g = gap_to_wall(walls, id, s.x[a], s.y[a], s.z[a], s.radius[a]);
    if (!(g.overlap > 0.0)) continue;
    const auto i = static_cast<std::size_t>(s.body[a]);
    const double to_a = s.radius[a] - g.overlap;  // contact point: on the plane
    c.slot[k] = static_cast<std::int32_t>(p);
    c.body_a[k] = s.body[a], c.body_b[k] = id;
    c.nx[k] = g.nx, c.ny[k] = g.ny, c.nz[k] = g.nz, c.overlap[k] = g.overlap;
    c.ax[k] = s.x[a] - bodies.x[i] - to_a * g.nx;
    c.ay[k] = s.y[a] - bodies.y[i] - to_a * g.ny;
    c.az[k] = s.z[a] - bodies.z[i] - to_a * g.nz;
    Vec3 v = point_velocity(bodies, i, c.ax[k], c.ay[k], c.az[k]);
    v[static_cast<std::size_t>(axis_of(id))] -= walls[id].velocity;
    c.vx[k] = v[0], c.vy[k] = v[1], c.vz[k] = v[2];
    c.friction[k] = walls[id].friction;
    c.root_mass[k] = law.damping_is_ratio ? std::sqrt(bodies.mass[i]) : 1.0;
    ++k;
  }
  segment.count = k - segment.begin;
  take_history(walls.history, step, c, segment.begin, k);
}

REGOLAB_HOT void apply_law(const LinearLaw& shared_law, double dt, Contacts& c, const Contacts::Segment& segment) {
  const LinearLaw law = shared_law;  // a copy: stores below cannot alias it
  const std::size_t begin = segment.begin, end = segment.begin + segment.count;
  const double *nx = c.nx.data(), *ny = c.ny.data(), *nz = c.nz.data(), *overlap = c.overlap.data();
  const double *vx = c.vx.data(), *vy = c.vy.data(), *vz = c.vz.data();
  const double *friction = c.friction.data(), *root_mass = c.root_mass.data();
  double *sx = c.sx.data(), *sy = c.sy.data(), *sz = c.sz.data(), *fx = c.fx.data(), *fy = c.fy.data(), *fz = c.fz.data();
#pragma GCC ivdep
  for (std::size_t k = begin; k < end; ++k) {
    ContactPoint p{nx[k], ny[k], nz[k], overlap[k], vx[k], vy[k], vz[k], sx[k], sy[k], sz[k], 0, 0, 0};
    linear_contact(law, friction[k], root_mass[k], dt, p);
    sx[k] = p.sx, sy[k] = p.sy, sz[k] = p.sz;
    fx[k] = p.fx, fy[k] = p.fy, fz[k] = p.fz;
  }
}

void store_history(const Contacts& c, std::int64_t step, History& history) {
  c.each([&](std::size_t k) {
    const auto h = static_cast<std::size_t>(c.slot[k]);
    history.sx[h] = c.sx[k];
    history.sy[h] = c.sy[k];
    history.sz[h] = c.sz[k];
    history.touched[h] = step;
  });
}

void scatter_pairs(const Contacts& c, Bodies& b) {
  c.each([&](std::size_t k) {
    push(b, static_cast<std::size_t>(c.body_a[k]), c.fx[k], c.fy[k], c.fz[k], c.ax[k], c.ay[k], c.az[k]);
    push(b, static_cast<std::size_t>(c.body_b[k]), -c.fx[k], -c.fy[k], -c.fz[k], c.bx[k], c.by[k], c.bz[k]);
  });
}

void scatter_walls(const Contacts& c, Bodies& b, Walls& walls) {
  for (Wall& wall : walls.wall) wall.force = wall.shear = 0.0, wall.contacts = 0;
  c.each([&](std::size_t k) {
    push(b, static_cast<std::size_t>(c.body_a[k]), c.fx[k], c.fy[k], c.fz[k], c.ax[k], c.ay[k], c.az[k]);
    Wall& wall = walls[c.body_b[k]];
    const double fn = c.fx[k] * c.nx[k] + c.fy[k] * c.ny[k] + c.fz[k] * c.nz[k];
    const double tx = c.fx[k] - fn * c.nx[k], ty = c.fy[k] - fn * c.ny[k], tz = c.fz[k] - fn * c.nz[k];
    wall.force += fn;
    wall.shear += std::sqrt(tx * tx + ty * ty + tz * tz);
    ++wall.contacts;
  });
}

}  // namespace regolab::dem
