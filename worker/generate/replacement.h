/// Replacement of parent spheres by clusters, and their rotation [article Sec. 2.3; protocols, section 1].
#pragma once
#include "vocab/micro.h"
#include "worker/dem/world.h"
#include "worker/generate/parents.h"

namespace regolab::generate {

/// Fills `world` with one cluster at rest per parent. The mixture holds one third of each N_E by number, and two-sphere clusters
/// one third of each kind. Grains smaller than mass_floor * L_S carry the mass of that size (shape and volume stay their own).
void replace_parents(const Parents& parents, const Micro& micro, double mass_floor, const Random& random, dem::World& world);

/// Deepest overlap between spheres of different clusters [m]; <= 0 after a sound replacement.
double deepest_overlap_between_clusters(const dem::World& world);

}  // namespace regolab::generate
