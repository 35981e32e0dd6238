#include "worker/generate/replacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "worker/generate/clump_shapes.h"

namespace regolab::generate {
namespace {

/// Each particle's place in a random order of all: kinds are dealt by it, so shares are exact and independent of size.
std::vector<int> random_ranks(std::size_t n, const Random& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> key(n);
  for (std::size_t i = 0; i < n; ++i) key[i] = random.uniform(Purpose::kKind, i);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key[a] < key[b] || (key[a] == key[b] && a < b); });
  std::vector<int> rank(n);
  for (std::size_t k = 0; k < n; ++k) rank[order[k]] = static_cast<int>(k);
  return rank;
}

Clump clump_for(const Micro& micro, double radius, int rank, std::uint64_t particle, const Random& random) {
  const auto u = [&](std::uint64_t draw) { return random.uniform(Purpose::kAspect, particle, draw); };
  const AxisRatios ratios = axis_ratios(u(0), u(1), u(2));
  ParticleKind kind = micro.kind;
  int deal = rank;
  if (kind == ParticleKind::kMixture) {
    constexpr ParticleKind kThirds[] = {ParticleKind::kTwo, ParticleKind::kFour, ParticleKind::kSix};
    kind = kThirds[rank % 3];
    deal = rank / 3;
  }
  switch (kind) {
    case ParticleKind::kTwo: return two_element(radius, static_cast<TwoKind>(deal % 3), ratios);
    case ParticleKind::kFour: return four_element(radius, ratios);
    default: return six_element(radius, ratios);
  }
}

void turn_about_x(Clump& clump, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto& p : clump.centre) p = {p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]};
}

void turn_about_z(Clump& clump, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto& p : clump.centre) p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
}

/// About the parent centre, which keeps every kind inside its parent; x first, then z.
void rotate(Clump& clump, Rotation rotation, std::uint64_t particle, const Random& random) {
  const auto angle = [&](std::uint64_t draw) { return 2 * std::numbers::pi * random.uniform(Purpose::kRotation, particle, draw); };
  if (rotation == Rotation::kX || rotation == Rotation::kXZ) turn_about_x(clump, angle(0));
  if (rotation == Rotation::kZ || rotation == Rotation::kXZ) turn_about_z(clump, angle(1));
}

}  // namespace

void replace_parents(const Parents& parents, const Micro& micro, double mass_floor, const Random& random, dem::World& world) {
  const std::vector<int> rank = random_ranks(parents.centre.size(), random);
  for (std::size_t i = 0; i < parents.centre.size(); ++i) {
    Clump clump = clump_for(micro, parents.radius[i], rank[i], i, random);
    rotate(clump, micro.rotation, i, random);
    for (auto& centre : clump.centre) {
      for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += parents.centre[i][axis];
    }
    const double diameter = 2 * parents.radius[i];
    const double lift = mass_floor * micro.largest_diameter / diameter;
    dem::add_cluster({.centre = clump.centre,
                      .radius = clump.radius,
                      .density = micro.grain_density,
                      .mass_factor = lift > 1 ? lift * lift * lift : 1.0,
                      .parent_diameter = diameter},
                     world.bodies, world.spheres);
  }
}

double deepest_overlap_between_clusters(const dem::World& world) {
  const dem::Spheres& s = world.spheres;
  dem::PairList pairs;
  const dem::Centres at = dem::sphere_centres(world.bodies, s);
  pairs.allowance.assign(world.bodies.x.size(), 0.0);
  dem::build_pairs(world.bodies, s, at, 0.0, pairs);
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < pairs.a.size(); ++k) {
    const auto a = static_cast<std::size_t>(pairs.a[k]), b = static_cast<std::size_t>(pairs.b[k]);
    const double distance = std::hypot(at.x[a] - at.x[b], at.y[a] - at.y[b], at.z[a] - at.z[b]);
    deepest = std::max(deepest, pairs.sum_of_radii[k] - distance);
  }
  return deepest;
}

}  // namespace regolab::generate
