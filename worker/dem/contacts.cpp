#include "worker/dem/contacts.h"

#include <cmath>

namespace regolab::dem {
namespace {

/// What a gather writes for one contact; the arrays are filled from it in one place.
struct Found {
  std::int32_t slot, body_a, body_b;
  double nx, ny, nz, overlap;
  double ax, ay, az, bx, by, bz;
  double vx, vy, vz;
  double friction, root_mass;
};

void put(Contacts& c, std::size_t k, const Found& f, const History& history, std::int64_t step) {
  c.slot[k] = f.slot;
  c.body_a[k] = f.body_a;
  c.body_b[k] = f.body_b;
  c.nx[k] = f.nx, c.ny[k] = f.ny, c.nz[k] = f.nz, c.overlap[k] = f.overlap;
  c.ax[k] = f.ax, c.ay[k] = f.ay, c.az[k] = f.az;
  c.bx[k] = f.bx, c.by[k] = f.by, c.bz[k] = f.bz;
  c.vx[k] = f.vx, c.vy[k] = f.vy, c.vz[k] = f.vz;
  c.friction[k] = f.friction;
  c.root_mass[k] = f.root_mass;
  const auto h = static_cast<std::size_t>(f.slot);
  const double carried = history.touched[h] + 1 >= step ? 1.0 : 0.0;
  c.sx[k] = carried * history.sx[h];
  c.sy[k] = carried * history.sy[h];
  c.sz[k] = carried * history.sz[h];
}

/// Velocity of the point at `arm` from the centre of mass of body i.
Vec3 point_velocity(const Bodies& b, std::size_t i, double ax, double ay, double az) {
  return {b.vx[i] + (b.wy[i] * az - b.wz[i] * ay), b.vy[i] + (b.wz[i] * ax - b.wx[i] * az),
          b.vz[i] + (b.wx[i] * ay - b.wy[i] * ax)};
}

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

void gather_pairs(const Bodies& bodies, const Spheres& s, const PairList& pairs, const LinearLaw& law, std::int64_t step,
                  Contacts& contacts, Contacts::Segment& segment) {
  std::size_t k = segment.begin;
  for (std::size_t p = segment.begin; p < segment.end; ++p) {
    const auto a = static_cast<std::size_t>(pairs.a[p]), b = static_cast<std::size_t>(pairs.b[p]);
    const double dx = s.x[a] - s.x[b], dy = s.y[a] - s.y[b], dz = s.z[a] - s.z[b];
    const double distance2 = dx * dx + dy * dy + dz * dz;
    const double reach = pairs.sum_of_radii[p];
    if (!(distance2 < reach * reach) || distance2 == 0.0) continue;
    const double distance = std::sqrt(distance2);
    const double nx = dx / distance, ny = dy / distance, nz = dz / distance;
    const double overlap = reach - distance;
    const auto i = static_cast<std::size_t>(s.body[a]), j = static_cast<std::size_t>(s.body[b]);
    const double to_a = s.radius[a] - 0.5 * overlap, to_b = s.radius[b] - 0.5 * overlap;  // contact point: middle of the overlap
    const double ax = s.x[a] - bodies.x[i] - to_a * nx, ay = s.y[a] - bodies.y[i] - to_a * ny, az = s.z[a] - bodies.z[i] - to_a * nz;
    const double bx = s.x[b] - bodies.x[j] + to_b * nx, by = s.y[b] - bodies.y[j] + to_b * ny, bz = s.z[b] - bodies.z[j] + to_b * nz;
    const Vec3 va = point_velocity(bodies, i, ax, ay, az), vb = point_velocity(bodies, j, bx, by, bz);
    const double root_mass = law.damping_is_ratio ? 1.0 / std::sqrt(bodies.inverse_mass[i] + bodies.inverse_mass[j]) : 1.0;
    put(contacts, k++,
        {static_cast<std::int32_t>(p), s.body[a], s.body[b], nx, ny, nz, overlap, ax, ay, az, bx, by, bz, va[0] - vb[0],
         va[1] - vb[1], va[2] - vb[2], law.friction, root_mass},
        pairs.history, step);
  }
  segment.count = k - segment.begin;
}

void gather_walls(const Bodies& bodies, const Spheres& s, const Walls& walls, const LinearLaw& law, std::int64_t step,
                  Contacts& contacts, Contacts::Segment& segment) {
  std::size_t k = segment.begin;
  for (std::size_t p = segment.begin; p < segment.end; ++p) {
    const auto a = static_cast<std::size_t>(walls.sphere[p]);
    const int id = walls.id[p];
    const WallGap g = gap_to_wall(walls, id, s.x[a], s.y[a], s.z[a], s.radius[a]);
    if (!(g.overlap > 0.0)) continue;
    const auto i = static_cast<std::size_t>(s.body[a]);
    const double to_a = s.radius[a] - g.overlap;  // contact point: on the plane
    const double ax = s.x[a] - bodies.x[i] - to_a * g.nx, ay = s.y[a] - bodies.y[i] - to_a * g.ny, az = s.z[a] - bodies.z[i] - to_a * g.nz;
    Vec3 v = point_velocity(bodies, i, ax, ay, az);
    v[static_cast<std::size_t>(axis_of(id))] -= walls[id].velocity;
    const double root_mass = law.damping_is_ratio ? std::sqrt(bodies.mass[i]) : 1.0;
    put(contacts, k++,
        {static_cast<std::int32_t>(p), s.body[a], id, g.nx, g.ny, g.nz, g.overlap, ax, ay, az, 0, 0, 0, v[0], v[1], v[2],
         walls[id].friction, root_mass},
        walls.history, step);
  }
  segment.count = k - segment.begin;
}

void apply_law(const LinearLaw& law, double dt, Contacts& c, const Contacts::Segment& segment) {
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
