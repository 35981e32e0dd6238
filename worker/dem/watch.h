/// What a look at the world tells: energies, balance, overlaps, and whether the numbers can still be trusted.
#pragma once
#include "worker/dem/world.h"

namespace regolab::dem {

struct Energies {
  double kinetic = 0;      ///< translation and rotation, at the half step [J]
  double potential = 0;    ///< of the weights above z = 0 [J]
  double elastic = 0;      ///< of normal and tangential springs, walls included [J]
  double attraction = 0;   ///< of cohesive contacts, not positive [J]
  double total() const { return kinetic + potential + elastic + attraction; }
};
Energies energies(const World& world);

/// Mean size of the net force on the free clusters over the mean size of contact forces; 0 without contacts.
double unbalanced_force_ratio(const World& world);

/// Largest overlap over the smaller radius of its contact, walls included; at walls that give way, over what they give.
double deepest_overlap(const World& world);

/// Sum of the last step's contact forces on one body [N].
Vec3 contact_force_on(const World& world, int body);

bool finite(const World& world);

/// Mean kinetic energy per present free cluster over m g d / 2 (m the mean mass, d the mean diameter).
double relative_kinetic_energy(const World& world, double gravity, double mean_diameter);

/// Total weight of present clusters [N].
double weight(const World& world, double gravity);

/// The step that follows the smallest inertial mass, the stiffest spring and the strongest dashpot:
/// fraction * sqrt(m_min / K) * (sqrt(1 + zeta^2) - zeta) [physics, section 4]. A lagged dashpot needs the last factor.
double stable_step(const World& world, double fraction);

}  // namespace regolab::dem
