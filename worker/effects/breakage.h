/// Clusters that fall apart: a bond breaks when a contact presses a sphere of the cluster too hard.
#pragma once
#include <vector>

#include "worker/dem/world.h"

namespace regolab::effects {

/// Clusters, of two spheres or more, with a sphere that a contact of the last step presses with more than strength d^2, d its diameter.
std::vector<int> overloaded(const dem::World& world, double strength);

/// Replaces these clusters (in ascending order) by their spheres, each with its share of the mass by volume and the motion that it had in
/// the cluster: mass, momentum, angular momentum and kinetic energy stay. Spheres keep their numbers, and contacts their springs. The
/// step and the forces are the caller's to renew.
void break_clusters(const std::vector<int>& clusters, dem::World& world);

}  // namespace regolab::effects
