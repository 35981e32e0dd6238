#include "worker/dem/integrate.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/hot.h"

namespace regolab::dem {
namespace {

struct Quaternion {
  double w, x, y, z;
};

REGOLAB_INLINE Quaternion normalised(const Quaternion& q) {
  const double scale = 1.0 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

/// q + h (w at) / 2, normalised, with w the angular velocity in space and `at` the turn where the rate is taken.
REGOLAB_INLINE Quaternion turned(const Quaternion& q, const Quaternion& at, double wx, double wy, double wz, double h) {
  const double k = 0.5 * h;
  return normalised({q.w + k * (-wx * at.x - wy * at.y - wz * at.z), q.x + k * (wx * at.w + wy * at.z - wz * at.y),
                     q.y + k * (wy * at.w + wz * at.x - wx * at.z), q.z + k * (wz * at.w + wx * at.y - wy * at.x)});
}

/// w = R I^-1 R^T L, for the body's principal inverse inertia (jx, jy, jz).
REGOLAB_INLINE void angular_velocity(const Quaternion& q, double jx, double jy, double jz, double lx, double ly, double lz, double& wx,
                             double& wy, double& wz) {
  const double a = 1 - 2 * (q.y * q.y + q.z * q.z), b = 2 * (q.x * q.y - q.w * q.z), c = 2 * (q.x * q.z + q.w * q.y);
  const double d = 2 * (q.x * q.y + q.w * q.z), e = 1 - 2 * (q.x * q.x + q.z * q.z), f = 2 * (q.y * q.z - q.w * q.x);
  const double g = 2 * (q.x * q.z - q.w * q.y), h = 2 * (q.y * q.z + q.w * q.x), i = 1 - 2 * (q.x * q.x + q.y * q.y);
  const double px = jx * (a * lx + d * ly + g * lz), py = jy * (b * lx + e * ly + h * lz), pz = jz * (c * lx + f * ly + i * lz);
  wx = a * px + b * py + c * pz;
  wy = d * px + e * py + f * pz;
  wz = g * px + h * py + i * pz;
}

REGOLAB_HOT void translate(double gravity, double keep, double dt, Bodies& bodies) {
  const std::size_t n = bodies.x.size();
  const double* inverse_mass = bodies.inverse_mass.data();
  double *x = bodies.x.data(), *y = bodies.y.data(), *z = bodies.z.data();
  double *vx = bodies.vx.data(), *vy = bodies.vy.data(), *vz = bodies.vz.data();
  const double *fx = bodies.fx.data(), *fy = bodies.fy.data(), *fz = bodies.fz.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const double g = inverse_mass[i] > 0.0 ? gravity : 0.0;
    vx[i] = keep * vx[i] + dt * (inverse_mass[i] * fx[i]);
    vy[i] = keep * vy[i] + dt * (inverse_mass[i] * fy[i]);
    vz[i] = keep * vz[i] + dt * (inverse_mass[i] * fz[i] - g);
    x[i] += dt * vx[i];
    y[i] += dt * vy[i];
    z[i] += dt * vz[i];
  }
}

REGOLAB_HOT void turn(double keep, double dt, Bodies& bodies) {
  const std::size_t n = bodies.x.size();
  const double *jx = bodies.inverse_ix.data(), *jy = bodies.inverse_iy.data(), *jz = bodies.inverse_iz.data();
  const double *tx = bodies.tx.data(), *ty = bodies.ty.data(), *tz = bodies.tz.data();
  double *lx = bodies.lx.data(), *ly = bodies.ly.data(), *lz = bodies.lz.data();
  double *wx = bodies.wx.data(), *wy = bodies.wy.data(), *wz = bodies.wz.data();
  double *qw = bodies.qw.data(), *qx = bodies.qx.data(), *qy = bodies.qy.data(), *qz = bodies.qz.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const double is_free = jx[i] > 0.0 ? 1.0 : 0.0;
    lx[i] = keep * lx[i] + is_free * dt * tx[i];
    ly[i] = keep * ly[i] + is_free * dt * ty[i];
    lz[i] = keep * lz[i] + is_free * dt * tz[i];
    const Quaternion q{qw[i], qx[i], qy[i], qz[i]};
    double ax, ay, az;
    angular_velocity(q, jx[i], jy[i], jz[i], lx[i], ly[i], lz[i], ax, ay, az);
    const Quaternion half = turned(q, q, ax, ay, az, 0.5 * dt);
    angular_velocity(half, jx[i], jy[i], jz[i], lx[i], ly[i], lz[i], ax, ay, az);
    const Quaternion end = turned(q, half, ax, ay, az, dt);  // the midpoint rule
    qw[i] = end.w, qx[i] = end.x, qy[i] = end.y, qz[i] = end.z;
    wx[i] = ax, wy[i] = ay, wz[i] = az;
  }
}

}  // namespace

void kick_and_drift(double gravity, double drag, double dt, Bodies& bodies) {
  const double keep = drag > 0.0 ? std::max(0.0, 1.0 - drag * dt) : 1.0;
  translate(gravity, keep, dt, bodies);
  turn(keep, dt, bodies);
}

void clear_forces(Bodies& b) {
  for (auto* force : {&b.fx, &b.fy, &b.fz, &b.tx, &b.ty, &b.tz}) std::fill(force->begin(), force->end(), 0.0);
}

}  // namespace regolab::dem
