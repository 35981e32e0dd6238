/// Worlds of a few clusters, for checks against closed answers. SI throughout.
#pragma once
#include <string>

#include "worker/dem/contacts.h"
#include "worker/dem/step.h"
#include "worker/dem/watch.h"
#include "worker/dem/world.h"
#include "worker/generate/clump_shapes.h"

namespace regolab::test {

using dem::Vec3;
using dem::World;

/// An undamped, frictionless law with equal normal and tangential stiffness [N/m].
dem::LinearLaw elastic_law(double stiffness);

/// No clusters, walls or gravity yet; `dt` is 0.15 sqrt(1 kg / K) until set.
World empty_world(const dem::LinearLaw& law);

/// A cluster of one sphere; returns its index. The skin of the lists follows the largest radius.
int add_sphere(World& world, const Vec3& centre, double radius, double density = 2930);

/// A cluster placed with its parent centre at `centre`.
int add_clump(World& world, const generate::Clump& clump, const Vec3& centre, double density = 2930);

/// A wall at `position` along its axis, with this friction (tan).
void add_wall(World& world, int wall, double position, double friction = 0);

void set_velocity(World& world, int body, const Vec3& velocity);
/// Sets the angular momentum that belongs to this angular velocity [1/s].
void set_spin(World& world, int body, const Vec3& spin);
/// Turns a cluster about its centre of mass by `angle` [rad] about the unit vector `axis`.
void turn(World& world, int body, const Vec3& axis, double angle);

Vec3 velocity(const World& world, int body);
Vec3 position(const World& world, int body);
Vec3 spin(const World& world, int body);

void run(World& world, int steps);
/// Runs with a drag that takes most of the motion in one period of the stiffest spring, until nothing moves. False if it
/// does.
bool relax(World& world, int most_steps = 400000);

Vec3 cross(const Vec3& a, const Vec3& b);
double dot(const Vec3& a, const Vec3& b);
double norm(const Vec3& a);
Vec3 operator+(const Vec3& a, const Vec3& b);
Vec3 operator-(const Vec3& a, const Vec3& b);
Vec3 operator*(double s, const Vec3& a);

/// R I^-1 R^T v: the answer of a body's turn to a torque impulse.
Vec3 inverse_inertia_times(const World& world, int body, const Vec3& v);
/// R I R^T v.
Vec3 inertia_times(const World& world, int body, const Vec3& v);

/// Sums over all bodies: momentum [kg m/s] and angular momentum about the origin [kg m2/s].
Vec3 total_momentum(const World& world);
Vec3 total_angular_momentum(const World& world);

/// The whole state as bytes: equal bytes, equal bits.
std::string state_bytes(World& world);

}  // namespace regolab::test
