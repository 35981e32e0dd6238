#include "worker/dem/forces.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/laws/cohesion.h"
#include "worker/dem/laws/hertz.h"
#include "worker/dem/laws/rolling.h"
#include "worker/dem/simd/records.h"

namespace regolab::dem {
namespace {

/// Slots are worked through in blocks that stay in the first cache, phase by phase: measure, law, add. One loop over everything would
/// be a chain too long for the processor to overlap (measured: 1.6 times slower).
constexpr std::size_t kBlock = 64;

struct Axes {
  alignas(64) double x[kBlock], y[kBlock], z[kBlock];
};
struct Block {
  std::size_t first = 0;  ///< slot
  std::size_t count = 0;  ///< slots; the phases before the last work on whole packs
  Axes normal, point, velocity, force;
  alignas(64) double overlap[kBlock];  ///< not positive: does not touch
  alignas(64) double friction[kBlock];
};

/// What effects need besides: chosen once for a stretch, so that a world without any runs the plain code.
struct EffectBlock : Block {
  Axes spin, moment;                    ///< of a relative to b [1/s], on a [N m]
  alignas(64) double reduced[kBlock];   ///< R* [m]
};

template <class P>
REGOLAB_INLINE Triple<P> load3(const Axes& a, std::size_t k) { return {load<P>(a.x + k), load<P>(a.y + k), load<P>(a.z + k)}; }
template <class P>
REGOLAB_INLINE void store3(const Triple<P>& v, Axes& a, std::size_t k) { store(v.x, a.x + k), store(v.y, a.y + k), store(v.z, a.z + k); }

REGOLAB_INLINE std::size_t lane(const std::int32_t* index, std::size_t k, int l) {
  return static_cast<std::size_t>(index[k + static_cast<std::size_t>(l)]);
}

template <class P>
REGOLAB_INLINE void keep_for_effects(std::size_t, const Triple<P>&, const P&, Block&) {}
template <class P>
REGOLAB_INLINE void keep_for_effects(std::size_t k, const Triple<P>& spin, const P& reduced_radius, EffectBlock& block) {
  store3(spin, block.spin, k);
  store(reduced_radius, block.reduced + k);
}

template <class P, class Visit>
REGOLAB_INLINE void each_pack(const Block& block, Visit visit) {
  for (std::size_t k = 0; k < block.count; k += static_cast<std::size_t>(kLanes<P>)) visit(k);
}

template <class P>
REGOLAB_INLINE int lanes_left(const Block& block, std::size_t k) {
  return static_cast<int>(std::min<std::size_t>(block.count - k, static_cast<std::size_t>(kLanes<P>)));
}

/// Velocity of the points p of clusters [m/s].
template <class P>
REGOLAB_INLINE Triple<P> velocity_at(const Triple<P>& p, const Triple<P>& origin_velocity, const Triple<P>& spin) {
  return origin_velocity + cross(spin, p);
}

template <class P, class B>
REGOLAB_INLINE void measure_pairs(const ForceInput& in, const Slots& s, B& block) {
  const Quad* at = in.balls.at.data();
  const Motion* motion = in.bodies.motion.data();
  const std::int32_t *ball_a = s.ball_a.data() + block.first, *ball_b = s.ball_b.data() + block.first;
  const std::int32_t *body_a = s.body_a.data() + block.first, *body_b = s.body_b.data() + block.first;
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const auto a = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return at[lane(ball_a, k, l)].v; });
    const auto b = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return at[lane(ball_b, k, l)].v; });
    const Triple<P> d = a.xyz - b.xyz;
    const P reach = a.fourth + b.fourth, distance = root(dot(d, d)), one = pack_of<P>(1.0);
    const auto apart = distance > 0.0;  // centres on one another have no normal: they do not touch
    const Triple<P> n = (one / select(apart, distance, one)) * d;
    const P overlap = select(apart, reach - distance, P{});
    const Triple<P> point = a.xyz + (0.5 * overlap - a.fourth) * n;  // middle of the overlap
    const auto va = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body_a, k, l)].origin_velocity.v; });
    const auto vb = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body_b, k, l)].origin_velocity.v; });
    const auto wa = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body_a, k, l)].spin.v; });
    const auto wb = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body_b, k, l)].spin.v; });
    store(overlap, block.overlap + k);
    store(pack_of<P>(in.law.friction), block.friction + k);
    store3(n, block.normal, k);
    store3(point, block.point, k);
    store3(velocity_at(point, va.xyz - vb.xyz, wa.xyz - wb.xyz), block.velocity, k);
    keep_for_effects(k, wa.xyz - wb.xyz, a.fourth * b.fourth / reach, block);
  });
}

/// The walls as records: inward normal and its offset from the origin; velocity and friction. The plate has no one normal: zeros.
struct WallRecords {
  explicit WallRecords(const Walls& walls)
      : floor_ends(std::isfinite(walls.floor_end)), has_plate(walls[kPlate].present), end(walls.floor_end), top(walls[kFloor].position),
        plate_at{walls.plate.x, walls.plate.y, walls[kPlate].position}, plate_half(walls.plate.half) {
    for (int id = 0; id < kWalls; ++id) {
      const Vec3 n = normal_of(id);
      Quad &p = plane[id], &m = motion[id];
      std::copy(n.begin(), n.end(), p.v);
      p.v[3] = inward(id) * walls[id].position;
      m.v[axis_of(id)] = walls[id].velocity;
      m.v[3] = walls[id].friction;
    }
    motion[kPlate].v[2] = walls[kPlate].velocity;
    motion[kPlate].v[3] = walls[kPlate].friction;
  }
  Quad plane[kWallIds], motion[kWallIds];
  bool floor_ends, has_plate;
  double end, top;             ///< of a floor that ends [m]
  Vec3 plate_at, plate_half;   ///< centre and half edges [m]
};

template <class P>
struct FromWall {
  Triple<P> n;
  P distance;  ///< from the surface to the sphere's centre
};

/// A floor that ends is a solid block: its top, its edge, and the face below the edge.
template <class P>
REGOLAB_INLINE FromWall<P> from_block(const WallRecords& walls, const Triple<P>& at) {
  const P dx = at.x - walls.end, dz = at.z - walls.top, edge = root(dx * dx + dz * dz), zero{}, one = pack_of<P>(1.0);
  const auto at_edge = (dx > zero) & (dz > zero), at_face = dx > dz;
  const P per_edge = one / select(edge > zero, edge, one);
  return {{select(at_edge, dx * per_edge, select(at_face, one, zero)), zero,
           select(at_edge, dz * per_edge, select(at_face, zero, one))},
          select(at_edge, edge, select(at_face, dx, dz))};
}

/// One axis of the plate: which side of its middle, and how far beyond its face.
template <class P>
struct BesidePlate {
  P side, beyond;
};
template <class P>
REGOLAB_INLINE BesidePlate<P> beside_plate(const P& at, double centre, double half) {
  const P from_centre = at - centre, one = pack_of<P>(1.0);
  const auto low = from_centre < 0.0;
  return {select(low, -one, one), select(low, -from_centre, from_centre) - half};
}

/// Outside a cuboid the nearest place lies on a face, an edge or a corner; from inside the way out is through the nearest face.
template <class P>
REGOLAB_INLINE FromWall<P> from_plate(const WallRecords& walls, const Triple<P>& at) {
  const P zero{}, one = pack_of<P>(1.0);
  const auto x = beside_plate(at.x, walls.plate_at[0], walls.plate_half[0]), y = beside_plate(at.y, walls.plate_at[1], walls.plate_half[1]),
             z = beside_plate(at.z, walls.plate_at[2], walls.plate_half[2]);
  const Triple<P> out{select(x.beyond > zero, x.beyond, zero), select(y.beyond > zero, y.beyond, zero),
                      select(z.beyond > zero, z.beyond, zero)};
  const P distance = root(dot(out, out)), per = select(distance > zero, distance, one);
  const auto outside = (x.beyond > zero) | (y.beyond > zero) | (z.beyond > zero);
  const auto face_x = (x.beyond >= y.beyond) & (x.beyond >= z.beyond), face_y = y.beyond >= z.beyond;
  const Triple<P> face{select(face_x, x.side, zero), select(face_x, zero, select(face_y, y.side, zero)),
                       select(face_x, zero, select(face_y, zero, z.side))};
  return {{select(outside, x.side * out.x / per, face.x), select(outside, y.side * out.y / per, face.y),
           select(outside, z.side * out.z / per, face.z)},
          select(outside, distance, select(face_x, x.beyond, select(face_y, y.beyond, z.beyond)))};
}

template <class P, class Mask>
REGOLAB_INLINE FromWall<P> chosen(const Mask& which, const FromWall<P>& yes, const FromWall<P>& no) {
  return {{select(which, yes.n.x, no.n.x), select(which, yes.n.y, no.n.y), select(which, yes.n.z, no.n.z)},
          select(which, yes.distance, no.distance)};
}

template <class P>
REGOLAB_INLINE FromWall<P> from_wall(const WallRecords& walls, const std::int32_t* id, const Triple<P>& at) {
  const auto plane = gathered<P>([&](int l) REGOLAB_INLINE_LAMBDA { return walls.plane[id[l]].v; });
  FromWall<P> gap{plane.xyz, dot(plane.xyz, at) - plane.fourth};
  if (walls.floor_ends) gap = chosen(plane.xyz.z > 0.0, from_block(walls, at), gap);
  if (walls.has_plate) gap = chosen(dot(plane.xyz, plane.xyz) > 0.0, gap, from_plate(walls, at));
  return gap;
}

template <class P, class B>
REGOLAB_INLINE void measure_walls(const ForceInput& in, const WallRecords& walls, const Slots& s, B& block) {
  const Quad* at = in.balls.at.data();
  const Motion* motion = in.bodies.motion.data();
  const std::int32_t *ball = s.ball_a.data() + block.first, *body = s.body_a.data() + block.first, *id = s.second.data() + block.first;
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const auto a = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return at[lane(ball, k, l)].v; });
    const auto wall = gathered<P>([&](int l) REGOLAB_INLINE_LAMBDA { return walls.motion[lane(id, k, l)].v; });
    const auto v = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body, k, l)].origin_velocity.v; });
    const auto w = gathered<P>([=](int l) REGOLAB_INLINE_LAMBDA { return motion[lane(body, k, l)].spin.v; });
    const FromWall<P> gap = from_wall(walls, id + k, a.xyz);
    const Triple<P> point = a.xyz - gap.distance * gap.n;  // on the wall
    store(a.fourth - gap.distance, block.overlap + k);
    store(wall.fourth, block.friction + k);
    store3(gap.n, block.normal, k);
    store3(point, block.point, k);
    store3(velocity_at(point, v.xyz - wall.xyz, w.xyz), block.velocity, k);
    keep_for_effects(k, w.xyz, a.fourth, block);
  });
}

/// Springs in and out of their slots; what does not touch leaves zeros.
template <class P>
REGOLAB_INLINE void apply_law(const LinearLaw& shared_law, double dt, Slots& s, Block& block) {
  const LinearLaw law = shared_law;  // a copy: stores below cannot alias it
  const auto in_slot = [&](std::vector<double>& field) REGOLAB_INLINE_LAMBDA { return field.data() + block.first; };
  double *sx = in_slot(s.sx), *sy = in_slot(s.sy), *sz = in_slot(s.sz), *fx = in_slot(s.fx), *fy = in_slot(s.fy), *fz = in_slot(s.fz);
  const double* root_mass = in_slot(s.root_mass);
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const Triple<P> n = load3<P>(block.normal, k), v = load3<P>(block.velocity, k);
    const P overlap = load<P>(block.overlap + k), zero{};
    const auto touches = overlap > zero;
    const int lanes = lanes_left<P>(block, k);  // what follows may be another thread's
    ContactPoint<P> c{n.x, n.y, n.z, overlap, v.x, v.y, v.z, load_lanes<P>(sx + k, lanes), load_lanes<P>(sy + k, lanes),
                      load_lanes<P>(sz + k, lanes)};
    linear_contact(law, load<P>(block.friction + k), load<P>(root_mass + k), dt, c);
    const Triple<P> spring{select(touches, c.sx, zero), select(touches, c.sy, zero), select(touches, c.sz, zero)},
        f{select(touches, c.fx, zero), select(touches, c.fy, zero), select(touches, c.fz, zero)};
    store_lanes(spring.x, sx + k, lanes), store_lanes(spring.y, sy + k, lanes), store_lanes(spring.z, sz + k, lanes);
    store_lanes(f.x, fx + k, lanes), store_lanes(f.y, fy + k, lanes), store_lanes(f.z, fz + k, lanes);
    store3(f, block.force, k);
  });
}

/// The contact's push and tangential force, and the springs' stiffness, which rolling needs too.
template <class P>
REGOLAB_INLINE Stiffened<P> push(const LinearLaw& law, const P& friction, const P& root_mass, double dt, ContactPoint<P>& c) {
  const Stiffened<P> k = law.effects.hertz > 0
                             ? stiffened(law, c.overlap)
                             : Stiffened<P>{pack_of<P>(law.normal_stiffness), pack_of<P>(law.tangential_stiffness), pack_of<P>(1.0)};
  contact_with(law, k, friction, root_mass, dt, c);
  return k;
}

/// Rolling angles in and out of their slots; moments, zero where nothing touches, into the block.
template <class P>
REGOLAB_INLINE void roll(const LinearLaw& law, const Stiffened<P>& k, const P& root_mass, double dt, const ContactPoint<P>& c,
                         std::size_t at, int lanes, Slots& s, EffectBlock& block) {
  const Triple<P> w = load3<P>(block.spin, at);
  const std::size_t slot = block.first + at;
  double *rx = s.rx.data() + slot, *ry = s.ry.data() + slot, *rz = s.rz.data() + slot;
  RollingSpring<P> r{w.x, w.y, w.z, load_lanes<P>(rx, lanes), load_lanes<P>(ry, lanes), load_lanes<P>(rz, lanes)};
  const P pressed = c.fx * c.nx + c.fy * c.ny + c.fz * c.nz, zero{};
  rolling_moment(law, k, pressed, load<P>(block.reduced + at), root_mass, dt, c, r);
  const auto touches = c.overlap > zero;
  store_lanes(select(touches, r.rx, zero), rx, lanes), store_lanes(select(touches, r.ry, zero), ry, lanes);
  store_lanes(select(touches, r.rz, zero), rz, lanes);
  store3<P>({select(touches, r.mx, zero), select(touches, r.my, zero), select(touches, r.mz, zero)}, block.moment, at);
}

/// The same with what the law has beyond: stiffening springs, attraction, moments against rolling.
template <class P>
REGOLAB_INLINE void apply_law(const LinearLaw& shared_law, double dt, Slots& s, EffectBlock& block) {
  const LinearLaw law = shared_law;
  const auto in_slot = [&](std::vector<double>& field) REGOLAB_INLINE_LAMBDA { return field.data() + block.first; };
  double *sx = in_slot(s.sx), *sy = in_slot(s.sy), *sz = in_slot(s.sz), *fx = in_slot(s.fx), *fy = in_slot(s.fy), *fz = in_slot(s.fz);
  const double* root_mass = in_slot(s.root_mass);
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const Triple<P> n = load3<P>(block.normal, k), v = load3<P>(block.velocity, k);
    const P overlap = load<P>(block.overlap + k), root = load<P>(root_mass + k), zero{};
    const auto touches = overlap > zero;
    const int lanes = lanes_left<P>(block, k);
    ContactPoint<P> c{n.x, n.y, n.z, overlap, v.x, v.y, v.z, load_lanes<P>(sx + k, lanes), load_lanes<P>(sy + k, lanes),
                      load_lanes<P>(sz + k, lanes)};
    const Stiffened<P> stiffness = push(law, load<P>(block.friction + k), root, dt, c);
    if (law.effects.rolling > 0) roll(law, stiffness, root, dt, c, k, lanes, s, block);
    const Triple<P> spring{select(touches, c.sx, zero), select(touches, c.sy, zero), select(touches, c.sz, zero)};
    Triple<P> f{select(touches, c.fx, zero), select(touches, c.fy, zero), select(touches, c.fz, zero)};
    if (law.effects.cohesion > 0) f = f - attraction(law.effects, overlap, load<P>(block.reduced + k)) * n;
    store_lanes(spring.x, sx + k, lanes), store_lanes(spring.y, sy + k, lanes), store_lanes(spring.z, sz + k, lanes);
    store_lanes(f.x, fx + k, lanes), store_lanes(f.y, fy + k, lanes), store_lanes(f.z, fz + k, lanes);
    store3(f, block.force, k);
    if (!(law.effects.rolling > 0)) store3<P>({zero, zero, zero}, block.moment, k);
  });
}

/// Torque about the origin that a contact gives to a.
template <class P>
REGOLAB_INLINE Triple<P> torque_of(const Block& block, std::size_t k, const Triple<P>& f) {
  return cross(load3<P>(block.point, k), f);
}
template <class P>
REGOLAB_INLINE Triple<P> torque_of(const EffectBlock& block, std::size_t k, const Triple<P>& f) {
  return cross(load3<P>(block.point, k), f) + load3<P>(block.moment, k);
}

REGOLAB_INLINE void add(const Four& v, double* to) { store(load<Four>(to) + v, to); }
REGOLAB_INLINE void take(const Four& v, double* from) { store(load<Four>(from) - v, from); }

/// Forces and torques onto both clusters, slot after slot.
template <class P, class B>
REGOLAB_INLINE void add_pairs(const Slots& s, const B& block, const LoadTarget& target) {
  const std::int32_t *body_a = s.body_a.data() + block.first, *onto_b = s.onto_b.data() + block.first;
  Load *clusters = target.clusters, *cells = target.cells;
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const Triple<P> f = load3<P>(block.force, k);
    const auto onto = [=](int l, const Four& force, const Four& torque) REGOLAB_INLINE_LAMBDA {
      const std::int32_t b_at = onto_b[k + static_cast<std::size_t>(l)];
      Load &a = clusters[lane(body_a, k, l)], &b = b_at >= 0 ? clusters[b_at] : cells[~b_at];
      add(force, &a.fx), add(torque, &a.tx);
      take(force, &b.fx), take(torque, &b.tx);
    };
    each_row(0, lanes_left<P>(block, k), onto, rows_of(f), rows_of(torque_of<P>(block, k, f)));
  });
}

template <class P, class B>
REGOLAB_INLINE void add_walls(const Slots& s, const B& block, const LoadTarget& target) {
  const std::int32_t* body_a = s.body_a.data() + block.first;
  Load* clusters = target.clusters;
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const Triple<P> f = load3<P>(block.force, k);
    const auto onto = [=](int l, const Four& force, const Four& torque) REGOLAB_INLINE_LAMBDA {
      Load& a = clusters[lane(body_a, k, l)];
      add(force, &a.fx), add(torque, &a.tx);
    };
    each_row(0, lanes_left<P>(block, k), onto, rows_of(f), rows_of(torque_of<P>(block, k, f)));
  });
}

/// Normal force and shear of each wall slot.
template <class P>
REGOLAB_INLINE void split_wall_forces(Slots& s, const Block& block) {
  each_pack<P>(block, [&](std::size_t k) REGOLAB_INLINE_LAMBDA {
    const Triple<P> f = load3<P>(block.force, k), n = load3<P>(block.normal, k);
    const P normal = dot(f, n);
    const Triple<P> t = f - normal * n;
    const int lanes = lanes_left<P>(block, k);
    store_lanes(select(load<P>(block.overlap + k) > 0.0, normal, pack_of<P>(kApart)), s.normal.data() + block.first + k, lanes);
    store_lanes(root(dot(t, t)), s.shear.data() + block.first + k, lanes);
  });
}

template <class B, class Work>
REGOLAB_INLINE void each_block(Stretch stretch, Work work) {
  B block;
  for (block.first = stretch.begin; block.first < stretch.end; block.first += kBlock) {
    block.count = std::min(kBlock, stretch.end - block.first);
    work(block);
  }
}

template <class P, class B>
REGOLAB_INLINE void press_pair_blocks(const ForceInput& in, Stretch stretch, Slots& slots, LoadTarget target) {
  each_block<B>(stretch, [&](B& block) REGOLAB_INLINE_LAMBDA {
    measure_pairs<P>(in, slots, block);
    apply_law<P>(in.law, in.dt, slots, block);
    add_pairs<P>(slots, block, target);
  });
}

template <class P, class B>
REGOLAB_INLINE void press_wall_blocks(const ForceInput& in, const LinearLaw& law, const Walls& walls, Stretch stretch, Slots& slots,
                                      LoadTarget target) {
  const WallRecords records(walls);
  each_block<B>(stretch, [&](B& block) REGOLAB_INLINE_LAMBDA {
    measure_walls<P>(in, records, slots, block);
    apply_law<P>(law, in.dt, slots, block);
    split_wall_forces<P>(slots, block);
    add_walls<P>(slots, block, target);
  });
}

template <class P>
REGOLAB_INLINE void press_pairs_with(const ForceInput& in, Stretch stretch, Slots& slots, LoadTarget target) {
  if (in.law.effects.any()) return press_pair_blocks<P, EffectBlock>(in, stretch, slots, target);
  press_pair_blocks<P, Block>(in, stretch, slots, target);
}

template <class P>
REGOLAB_INLINE void press_walls_with(const ForceInput& in, const Walls& walls, Stretch stretch, Slots& slots, LoadTarget target) {
  if (in.law.effects.any()) return press_wall_blocks<P, EffectBlock>(in, at_walls(in.law), walls, stretch, slots, target);
  press_wall_blocks<P, Block>(in, in.law, walls, stretch, slots, target);
}

}  // namespace

REGOLAB_HOT(void, press_pairs, (const ForceInput& in, Stretch stretch, Slots& slots, LoadTarget target), (in, stretch, slots, target))
REGOLAB_HOT(void, press_walls, (const ForceInput& in, const Walls& walls, Stretch stretch, Slots& slots, LoadTarget target),
            (in, walls, stretch, slots, target))

void sum_wall_forces(const Slots& slots, Walls& walls) {
  for (Wall& wall : walls.wall) wall.force = wall.shear = 0.0, wall.contacts = 0;
  walls.plate.force = {};
  for (std::size_t k = 0; k < slots.count; ++k) {
    if (slots.normal[k] == kApart) continue;
    Wall& wall = walls[slots.second[k]];
    wall.force += slots.normal[k];
    wall.shear += slots.shear[k];
    ++wall.contacts;
    if (slots.second[k] != kPlate) continue;
    Vec3& on_plate = walls.plate.force;
    on_plate[0] -= slots.fx[k], on_plate[1] -= slots.fy[k], on_plate[2] -= slots.fz[k];
  }
}

}  // namespace regolab::dem
