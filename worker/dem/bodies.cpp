#include "worker/dem/bodies.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>


namespace regolab::dem {
namespace {

Eigen::Vector3d vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

struct MassProperties {
  double volume = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_per_density = Eigen::Matrix3d::Zero();
};

MassProperties mass_properties(const ClusterSpec& spec) {
  MassProperties out;
  const auto volume = [&](std::size_t i) { return 4.0 / 3.0 * std::numbers::pi * std::pow(spec.radius[i], 3); };
  for (std::size_t i = 0; i < spec.radius.size(); ++i) {
    out.volume += volume(i);
    out.centre += volume(i) * vector(spec.centre[i]);
  }
  out.centre /= out.volume;
  for (std::size_t i = 0; i < spec.radius.size(); ++i) {
    const Eigen::Vector3d d = vector(spec.centre[i]) - out.centre;
    const double own = 0.4 * spec.radius[i] * spec.radius[i];
    out.inertia_per_density +=
        volume(i) * ((own + d.squaredNorm()) * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
  return out;
}

void push_rigid_state(Bodies& b, const Eigen::Vector3d& centre, const Eigen::Quaterniond& q) {
  b.x.push_back(centre.x());
  b.y.push_back(centre.y());
  b.z.push_back(centre.z());
  b.qw.push_back(q.w());
  b.qx.push_back(q.x());
  b.qy.push_back(q.y());
  b.qz.push_back(q.z());
  for (auto* zero : {&b.vx, &b.vy, &b.vz, &b.lx, &b.ly, &b.lz, &b.wx, &b.wy, &b.wz}) {
    zero->push_back(0.0);
  }
  b.load.emplace_back();
  b.motion.emplace_back();
  b.placing.emplace_back();
  b.gone.push_back(0);
}

}  // namespace

void Bodies::hold_fixed(int body) {
  const auto i = static_cast<std::size_t>(body);
  inverse_mass[i] = inverse_ix[i] = inverse_iy[i] = inverse_iz[i] = 0.0;
  for (auto* zero : {&vx, &vy, &vz, &lx, &ly, &lz, &wx, &wy, &wz}) (*zero)[i] = 0.0;
}

int add_cluster(const ClusterSpec& spec, Bodies& bodies, Spheres& spheres) {
  const MassProperties p = mass_properties(spec);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(p.inertia_per_density);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);  // a turn, not a mirror
  const Eigen::Vector3d inertia = spec.density * spec.mass_factor * solver.eigenvalues();

  const int index = bodies.count();
  push_rigid_state(bodies, p.centre, Eigen::Quaterniond(axes).normalized());
  const double mass = spec.density * spec.mass_factor * p.volume;
  bodies.mass.push_back(mass);
  bodies.inverse_mass.push_back(1.0 / mass);
  bodies.inverse_ix.push_back(1.0 / inertia.x());
  bodies.inverse_iy.push_back(1.0 / inertia.y());
  bodies.inverse_iz.push_back(1.0 / inertia.z());
  bodies.solid_volume.push_back(p.volume);
  bodies.parent_diameter.push_back(spec.parent_diameter);

  double reach = 0, swing = 0;
  for (std::size_t i = 0; i < spec.radius.size(); ++i) {
    const Eigen::Vector3d d = vector(spec.centre[i]) - p.centre;
    const Eigen::Vector3d offset = axes.transpose() * d;
    spheres.body.push_back(index);
    spheres.ox.push_back(offset.x());
    spheres.oy.push_back(offset.y());
    spheres.oz.push_back(offset.z());
    spheres.radius.push_back(spec.radius[i]);
    reach = std::max(reach, d.norm() + spec.radius[i]);
    if (spec.radius.size() > 1) swing = std::max(swing, d.norm());
  }
  bodies.reach.push_back(reach);
  bodies.swing.push_back(swing);
  if (bodies.first_sphere.empty()) bodies.first_sphere.push_back(0);
  bodies.first_sphere.push_back(spheres.count());
  return index;
}

std::array<double, 9> rotation_of(const Bodies& bodies, int body) {
  const auto i = static_cast<std::size_t>(body);
  const double w = bodies.qw[i], x = bodies.qx[i], y = bodies.qy[i], z = bodies.qz[i];
  return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
          2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
          2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
}

void sphere_centres(const Bodies& bodies, const Spheres& spheres, Stretch clusters, Centres& out) {
  for (std::size_t i = clusters.begin; i < clusters.end; ++i) {
    const auto r = rotation_of(bodies, static_cast<int>(i));
    const double bx = bodies.x[i], by = bodies.y[i], bz = bodies.z[i];
    const auto end = static_cast<std::size_t>(bodies.first_sphere[i + 1]);
    for (auto s = static_cast<std::size_t>(bodies.first_sphere[i]); s < end; ++s) {
      const double ox = spheres.ox[s], oy = spheres.oy[s], oz = spheres.oz[s];
      out.x[s] = bx + (r[0] * ox + r[1] * oy + r[2] * oz);
      out.y[s] = by + (r[3] * ox + r[4] * oy + r[5] * oz);
      out.z[s] = bz + (r[6] * ox + r[7] * oy + r[8] * oz);
    }
  }
}

Centres sphere_centres(const Bodies& bodies, const Spheres& spheres) {
  Centres out;
  out.resize(static_cast<std::size_t>(spheres.count()));
  sphere_centres(bodies, spheres, {0, bodies.x.size()}, out);
  return out;
}

void publish_motion(Bodies& b) {
  b.motion.resize(b.x.size());
  b.placing.resize(b.x.size());
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    const Vec3 at_origin = point_velocity(b, i, -b.x[i], -b.y[i], -b.z[i]);
    b.motion[i] = {{at_origin[0], at_origin[1], at_origin[2]}, {b.wx[i], b.wy[i], b.wz[i]}};
    b.placing[i].centre = {b.x[i], b.y[i], b.z[i]};
    const auto r = rotation_of(b, static_cast<int>(i));
    for (std::size_t k = 0; k < 3; ++k) b.placing[i].column[k] = {r[k], r[3 + k], r[6 + k]};
  }
}

}  // namespace regolab::dem
