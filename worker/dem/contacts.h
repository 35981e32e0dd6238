/// The touching contacts as a list, for looks between steps: counts, energies, pictures. The step itself never makes it.
#pragma once
#include <cstdint>
#include <vector>

#include "worker/dem/world.h"

namespace regolab::dem {

/// n points from b to a; force and spring are those of the last step.
struct Contact {
  std::int32_t sphere_a, sphere_b;  ///< at a wall b is -1
  std::int32_t body_a, body_b;      ///< at a wall b is the wall's id
  Vec3 normal;
  double overlap;                   ///< [m]
  double reduced_radius;            ///< R*; R at a wall [m]
  Vec3 arm_a, arm_b;                ///< from each centre of mass to the contact point (walls: arm_b is zero) [m]
  Vec3 spring;                      ///< [m]
  Vec3 rolling;                     ///< angle, zero where nothing resists it
  Vec3 force;                       ///< on a [N]
};

/// Sphere-sphere contacts in canonical order, at the present positions; with a `gap` also those so near, with negative overlaps.
std::vector<Contact> contacts(const World& world, double gap = 0);

/// Contacts with walls, by wall then sphere.
std::vector<Contact> wall_contacts(const World& world);

}  // namespace regolab::dem
