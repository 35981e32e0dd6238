#include "worker/dem/watch.h"

#include <algorithm>
#include <cmath>

#include "worker/dem/contacts.h"
#include "worker/dem/laws/cohesion.h"
#include "worker/dem/laws/hertz.h"
#include "worker/dem/laws/rolling.h"

namespace regolab::dem {
namespace {

double square(const Vec3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

double energy_with_effects(const LinearLaw& law, const std::vector<Contact>& contacts) {
  const bool root_law = law.effects.hertz > 0;
  double sum = 0;
  for (const Contact& c : contacts) {
    const Stiffened<double> k = root_law ? stiffened(law, c.overlap) : Stiffened<double>{law.normal_stiffness, law.tangential_stiffness, 1};
    sum += normal_energy(law, c.overlap) + 0.5 * k.tangential * square(c.spring);
    if (law.effects.rolling > 0) sum += 0.5 * rolling_stiffness(law.effects, k, c.reduced_radius) * square(c.rolling);
  }
  return sum;
}

double elastic_energy(const LinearLaw& law, const std::vector<Contact>& contacts) {
  if (law.effects.any()) return energy_with_effects(law, contacts);
  double sum = 0;
  for (const Contact& c : contacts) {
    sum += 0.5 * law.normal_stiffness * c.overlap * c.overlap;
    sum += 0.5 * law.tangential_stiffness *
           (c.spring[0] * c.spring[0] + c.spring[1] * c.spring[1] + c.spring[2] * c.spring[2]);
  }
  return sum;
}

bool present(const Bodies& b, std::size_t i) { return !b.gone[i] && b.inverse_mass[i] > 0.0; }

double kinetic_of(const Bodies& b, std::size_t i) {
  const double translation = 0.5 * b.mass[i] * (b.vx[i] * b.vx[i] + b.vy[i] * b.vy[i] + b.vz[i] * b.vz[i]);
  return translation + 0.5 * (b.lx[i] * b.wx[i] + b.ly[i] * b.wy[i] + b.lz[i] * b.wz[i]);
}

}  // namespace

Energies energies(const World& world) {
  const Bodies& b = world.bodies;
  Energies e;
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    if (!present(b, i)) continue;
    e.kinetic += kinetic_of(b, i);
    e.potential += b.mass[i] * world.gravity * b.z[i];
  }
  e.elastic = elastic_energy(world.law, contacts(world)) + elastic_energy(at_walls(world.law), wall_contacts(world));
  if (world.law.effects.cohesion > 0) {
    for (const Contact& c : contacts(world, world.margins.attraction))
      e.attraction += attraction_energy(world.law.effects, c.overlap, c.reduced_radius);
  }
  return e;
}

double unbalanced_force_ratio(const World& world) {
  const Bodies& b = world.bodies;
  double net = 0;
  int free_bodies = 0;
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    if (!present(b, i)) continue;
    net += std::hypot(b.load[i].fx, b.load[i].fy, b.load[i].fz - b.mass[i] * world.gravity);
    ++free_bodies;
  }
  double contact = 0;
  std::size_t n = 0;
  for (const auto& touching : {contacts(world), wall_contacts(world)}) {
    for (const Contact& c : touching) contact += std::hypot(c.force[0], c.force[1], c.force[2]);
    n += touching.size();
  }
  if (free_bodies == 0 || n == 0 || contact == 0) return 0;
  return (net / free_bodies) / (contact / static_cast<double>(n));
}

double deepest_overlap(const World& world) {
  double deepest = 0;
  const auto radius = [&](std::int32_t sphere) { return world.spheres.radius[static_cast<std::size_t>(sphere)]; };
  for (const Contact& c : contacts(world)) {
    deepest = std::max(deepest, c.overlap / std::min(radius(c.sphere_a), radius(c.sphere_b)));
  }
  const double give = 1 + world.law.effects.wall_compliance;  // where a wall gives way, grains go in without going through
  for (const Contact& c : wall_contacts(world)) deepest = std::max(deepest, c.overlap / (give * radius(c.sphere_a)));
  return deepest;
}

Vec3 contact_force_on(const World& world, int body) {
  const auto i = static_cast<std::size_t>(body);
  return {world.bodies.load[i].fx, world.bodies.load[i].fy, world.bodies.load[i].fz};
}

bool finite(const World& world) {
  const Bodies& b = world.bodies;
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    if (!std::isfinite(b.x[i] + b.y[i] + b.z[i]) || !std::isfinite(b.vx[i] + b.vy[i] + b.vz[i]) ||
        !std::isfinite(b.lx[i] + b.ly[i] + b.lz[i])) {
      return false;
    }
  }
  return true;
}

double relative_kinetic_energy(const World& world, double gravity, double mean_diameter) {
  const Bodies& b = world.bodies;
  double kinetic = 0, mass = 0;
  for (std::size_t i = 0; i < b.x.size(); ++i) {
    if (!present(b, i)) continue;
    kinetic += kinetic_of(b, i);
    mass += b.mass[i];
  }
  return mass > 0 ? kinetic / (0.5 * mass * gravity * mean_diameter) : 0;
}

double weight(const World& world, double gravity) {
  double mass = 0;
  for (std::size_t i = 0; i < world.bodies.x.size(); ++i) {
    if (!world.bodies.gone[i]) mass += world.bodies.mass[i];
  }
  return mass * gravity;
}

double stable_step(const World& world, double fraction) {
  const LinearLaw& law = world.law;
  const double lightest = *std::min_element(world.bodies.mass.begin(), world.bodies.mass.end()), root = std::sqrt(lightest);
  const double stiffest = std::max(law.normal_stiffness, law.tangential_stiffness);
  const double strongest = std::max(Dashpot(law, law.normal_stiffness, law.normal_damping).eta(root),
                                    Dashpot(law, law.tangential_stiffness, law.tangential_damping).eta(root));
  const double zeta = strongest / (2 * std::sqrt(lightest * stiffest));  // stiffened springs keep it
  return fraction * std::sqrt(lightest / (step_stiffening(law) * stiffest)) * (std::sqrt(1 + zeta * zeta) - zeta);
}

}  // namespace regolab::dem
