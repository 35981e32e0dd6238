/// Rigid clusters and their spheres as structures of arrays. Clusters are the only bodies: spheres follow them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace regolab::dem {

using Vec3 = std::array<double, 3>;
/// Three numbers of a record and a fourth, together in one vector register.
struct alignas(32) Quad {
  double v[4] = {0, 0, 0, 0};
};

/// One cluster to be added. Spheres are tangent, so masses and inertias add up exactly (parallel axes).
struct ClusterSpec {
  std::vector<Vec3> centre;    ///< world positions of the spheres [m]
  std::vector<double> radius;  ///< [m]
  double density = 0;          ///< of the grain [kg/m3]
  double mass_factor = 1;      ///< > 1 for grains that carry the mass of a larger size
  double parent_diameter = 0;  ///< of the sphere it replaces [m]
};

/// A stretch [begin, end) of clusters, pairs, slots or balls: the share of a thread. Two meet at a multiple of kMostLanes.
struct Stretch {
  std::size_t begin, end;
};

/// Contact force [N] on a cluster and torque about the origin [N m]: what one contact gives to its two sides is equal and opposite.
struct alignas(64) Load {
  double fx = 0, fy = 0, fz = 0, unused_f = 0, tx = 0, ty = 0, tz = 0, unused_t = 0;
  template <class A>
  void archive(A& ar) { ar(fx, fy, fz, tx, ty, tz); }
};

/// What a contact asks of a cluster: the velocity of its body-fixed point that passes the origin, v - w x c [m/s], and its angular
/// velocity [1/s]. A point p of it moves at origin_velocity + spin x p, wherever the centre c is.
struct Motion {
  Quad origin_velocity, spin;
};
/// Where the spheres of a cluster go: its centre of mass [m] and the columns of the matrix that turns the principal frame into space.
struct Placing {
  Quad centre, column[3];
};

/// State of the clusters. Velocities and angular momenta stand half a step behind the positions (leapfrog).
struct Bodies {
  std::vector<double> x, y, z;              // [n] centre of mass [m]
  std::vector<double> vx, vy, vz;           // [n] [m/s]
  std::vector<double> qw, qx, qy, qz;       // [n] turns the principal frame into space
  std::vector<double> lx, ly, lz;           // [n] angular momentum, space frame [kg m2/s]
  std::vector<double> wx, wy, wz;           // [n] angular velocity, space frame [1/s]
  std::vector<double> inverse_mass;         // [n] 0 = held fixed
  std::vector<double> inverse_ix, inverse_iy, inverse_iz;  // [n] principal inertia, inverse [1/(kg m2)]
  std::vector<double> mass;                 // [n] inertial and heavy mass [kg]
  std::vector<double> solid_volume;         // [n] sum of sphere volumes [m3]
  std::vector<double> parent_diameter;      // [n] [m]
  std::vector<double> reach;                // [n] farthest point from the centre of mass [m]
  std::vector<double> swing;                // [n] farthest sphere centre from it: what a turn can move [m]
  std::vector<Load> load;                   // [n] of the last step
  std::vector<std::int32_t> first_sphere;   // [n + 1]
  std::vector<std::uint8_t> gone;           // [n] 1 = left the experiment (lies in the tray)

  // Follow from the state each step; not saved.
  std::vector<Motion> motion;               // [n]
  std::vector<Placing> placing;             // [n]

  int count() const { return static_cast<int>(x.size()); }
  void hold_fixed(int body);
  bool is_fixed(int body) const { return inverse_mass[static_cast<std::size_t>(body)] == 0.0; }

  template <class A>
  void archive(A& ar) {
    ar(x, y, z, vx, vy, vz, qw, qx, qy, qz, lx, ly, lz, wx, wy, wz, inverse_mass, inverse_ix, inverse_iy, inverse_iz, mass,
       solid_volume, parent_diameter, reach, swing, load, first_sphere, gone);
  }
};

/// Where they are follows from their clusters: sphere_centres().
struct Spheres {
  std::vector<std::int32_t> body;     // [m]
  std::vector<double> ox, oy, oz;     // [m] offset from the centre of mass, principal frame [m]
  std::vector<double> radius;         // [m] [m]

  int count() const { return static_cast<int>(body.size()); }

  template <class A>
  void archive(A& ar) { ar(body, ox, oy, oz, radius); }
};

/// Positions of all spheres in space.
struct Centres {
  std::vector<double> x, y, z;  // [m] [m]
  void resize(std::size_t n) { x.resize(n), y.resize(n), z.resize(n); }
};

/// Adds a cluster at rest; returns its index. REQUIRES: at least one sphere, density > 0.
int add_cluster(const ClusterSpec& spec, Bodies& bodies, Spheres& spheres);

/// Rotation matrix of a body, row major: space = R * principal.
std::array<double, 9> rotation_of(const Bodies& bodies, int body);

/// Velocity of the point that lies (ax, ay, az) from the centre of mass of body i [m/s].
inline Vec3 point_velocity(const Bodies& b, std::size_t i, double ax, double ay, double az) {
  return {b.vx[i] + (b.wy[i] * az - b.wz[i] * ay), b.vy[i] + (b.wz[i] * ax - b.wx[i] * az),
          b.vz[i] + (b.wx[i] * ay - b.wy[i] * ax)};
}

/// Adds a force through the centre of mass to what loads the cluster in the next step.
inline void push_centre(Bodies& b, int body, const Vec3& force) {
  const auto i = static_cast<std::size_t>(body);
  Load& on = b.load[i];
  on.fx += force[0], on.fy += force[1], on.fz += force[2];
  on.tx += b.y[i] * force[2] - b.z[i] * force[1];
  on.ty += b.z[i] * force[0] - b.x[i] * force[2];
  on.tz += b.x[i] * force[1] - b.y[i] * force[0];
}

/// Where the spheres are now; the second form does those of a stretch of clusters alone. REQUIRES: `out` is sized.
Centres sphere_centres(const Bodies& bodies, const Spheres& spheres);
void sphere_centres(const Bodies& bodies, const Spheres& spheres, Stretch clusters, Centres& out);

/// Motion and placing of every cluster from its state, where no step has just left them.
void publish_motion(Bodies& bodies);

}  // namespace regolab::dem
