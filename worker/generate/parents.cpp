#include "worker/generate/parents.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace regolab::generate {
namespace {

/// Bins of placed spheres, wide enough that only the 27 bins around a point matter.
class Occupied {
 public:
  Occupied(double length, double width, double height, double largest)
      : cell_(largest), nx_(bins(length)), ny_(bins(width)), nz_(bins(height)), bins_(nx_ * ny_ * nz_) {}

  bool has_room(const dem::Vec3& at, double radius, const Parents& placed) const {
    const int cx = bin(at[0], nx_), cy = bin(at[1], ny_), cz = bin(at[2], nz_);
    for (int z = std::max(cz - 1, 0); z <= std::min<int>(cz + 1, static_cast<int>(nz_) - 1); ++z) {
      for (int y = std::max(cy - 1, 0); y <= std::min<int>(cy + 1, static_cast<int>(ny_) - 1); ++y) {
        for (int x = std::max(cx - 1, 0); x <= std::min<int>(cx + 1, static_cast<int>(nx_) - 1); ++x) {
          for (const std::size_t j : bins_[index(x, y, z)]) {
            const double dx = at[0] - placed.centre[j][0], dy = at[1] - placed.centre[j][1], dz = at[2] - placed.centre[j][2];
            const double reach = radius + placed.radius[j];
            if (dx * dx + dy * dy + dz * dz < reach * reach) return false;
          }
        }
      }
    }
    return true;
  }
  void add(const dem::Vec3& at, std::size_t j) { bins_[index(bin(at[0], nx_), bin(at[1], ny_), bin(at[2], nz_))].push_back(j); }

 private:
  std::size_t bins(double extent) const { return static_cast<std::size_t>(std::max(1.0, std::floor(extent / cell_))); }
  int bin(double at, std::size_t n) const { return static_cast<int>(std::min(std::max(at / cell_, 0.0), static_cast<double>(n - 1))); }
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x) + nx_ * (static_cast<std::size_t>(y) + ny_ * static_cast<std::size_t>(z));
  }
  double cell_;
  std::size_t nx_, ny_, nz_;
  std::vector<std::vector<std::size_t>> bins_;
};

/// By place along the box: neighbours in space are then neighbours in memory, and a thread's share of clusters is a slab.
void sort_along(Parents& parents) {
  std::vector<std::size_t> order(parents.centre.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return parents.centre[a][0] < parents.centre[b][0]; });
  Parents sorted = parents;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted.centre[k] = parents.centre[order[k]];
    sorted.radius[k] = parents.radius[order[k]];
  }
  parents = std::move(sorted);
}

}  // namespace

std::vector<double> parent_diameters(int n, double largest, const Random& random, double finer) {
  const double smallest = largest / 5 * std::exp2(-finer), power = std::exp2(finer);
  std::vector<double> diameters(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const double u = (static_cast<double>(i) + random.uniform(Purpose::kDiameter, i)) / n;
    diameters[i] = smallest + (largest - smallest) * (finer == 0 ? u : std::pow(u, power));
  }
  std::reverse(diameters.begin(), diameters.end());
  return diameters;
}

std::optional<Parents> place_parents(const std::vector<double>& diameters, double length, double width, double fraction,
                                     double clearance, const Random& random) {
  double volume = 0;
  for (const double d : diameters) volume += std::numbers::pi / 6 * d * d * d;
  Parents placed;  // radii with their clearance while placing
  placed.fill_height = std::max(volume / (fraction * length * width), 1.2 * diameters.front());
  Occupied occupied(length, width, placed.fill_height, diameters.front() * (1 + clearance));
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    const double radius = 0.5 * diameters[i] * (1 + clearance);
    if (2 * radius >= std::min(length, width)) return std::nullopt;
    bool found = false;
    for (std::uint64_t attempt = 0; attempt < 20000 && !found; ++attempt) {
      const auto coordinate = [&](std::uint64_t axis, double extent) {
        return radius + (extent - 2 * radius) * random.uniform(Purpose::kPosition, i, 3 * attempt + axis);
      };
      const dem::Vec3 at = {coordinate(0, length), coordinate(1, width), coordinate(2, placed.fill_height)};
      if (!occupied.has_room(at, radius, placed)) continue;
      occupied.add(at, i);
      placed.centre.push_back(at);
      placed.radius.push_back(radius);
      found = true;
    }
    if (!found) return std::nullopt;
  }
  for (double& radius : placed.radius) radius /= 1 + clearance;
  sort_along(placed);
  return placed;
}

}  // namespace regolab::generate
