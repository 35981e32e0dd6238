#include "worker/protocol/surface.h"

#include <algorithm>
#include <cmath>

namespace regolab::protocol {
namespace {

template <class Visit>
void each_present_sphere(const Bed& bed, Visit visit) {
  const auto& s = bed.world.spheres;
  const dem::Centres at = dem::sphere_centres(bed.world.bodies, s);
  for (std::size_t i = 0; i < at.x.size(); ++i) {
    if (!bed.world.bodies.gone[static_cast<std::size_t>(s.body[i])]) visit(at.x[i], at.y[i], at.z[i], s.radius[i]);
  }
}

/// Grid points k (of n, at (k + 0.5) * spacing from `from`) within `radius` of `at`: [first, last].
struct Span {
  int first, last;
};
Span covered(double at, double radius, double from, double spacing, int n) {
  const double low = std::ceil((at - radius - from) / spacing - 0.5), high = std::floor((at + radius - from) / spacing - 0.5);
  return {static_cast<int>(std::clamp(low, 0.0, static_cast<double>(n))),
          static_cast<int>(std::clamp(high, -1.0, static_cast<double>(n - 1)))};
}

}  // namespace

std::vector<double> surface_heights(const Bed& bed, int nx, int ny) {
  std::vector<double> height(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0.0);
  const double dx = bed.length / nx, dy = bed.width / ny;
  each_present_sphere(bed, [&](double x, double y, double z, double r) {
    const Span columns = covered(x, r, 0, dx, nx), strips = covered(y, r, 0, dy, ny);
    for (int j = strips.first; j <= strips.last; ++j) {
      for (int i = columns.first; i <= columns.last; ++i) {
        const double ox = (i + 0.5) * dx - x, oy = (j + 0.5) * dy - y;
        const double rest = r * r - ox * ox - oy * oy;
        if (rest < 0) continue;
        double& h = height[static_cast<std::size_t>(i + nx * j)];
        h = std::max(h, z + std::sqrt(rest));
      }
    }
  });
  return height;
}

double mean_height(const Bed& bed) {
  const auto heights = surface_heights(bed, 24, 24);
  double sum = 0;
  for (const double h : heights) sum += h;
  return sum / static_cast<double>(heights.size());
}

double highest_point(const Bed& bed) {
  double top = 0;
  each_present_sphere(bed, [&](double, double, double z, double r) { top = std::max(top, z + r); });
  return top;
}

double core_solid_fraction(const Bed& bed, double height) {
  constexpr int kPoints = 96;  // along each axis: about 0.1 % of the fraction
  const double from[3] = {0.15 * bed.length, 0.15 * bed.width, 0.2 * height};
  const double spacing[3] = {0.7 * bed.length / kPoints, 0.7 * bed.width / kPoints, 0.55 * height / kPoints};
  std::vector<unsigned char> solid(static_cast<std::size_t>(kPoints) * kPoints * kPoints, 0);
  each_present_sphere(bed, [&](double x, double y, double z, double r) {
    const Span sx = covered(x, r, from[0], spacing[0], kPoints), sy = covered(y, r, from[1], spacing[1], kPoints),
               sz = covered(z, r, from[2], spacing[2], kPoints);
    for (int k = sz.first; k <= sz.last; ++k) {
      for (int j = sy.first; j <= sy.last; ++j) {
        for (int i = sx.first; i <= sx.last; ++i) {
          const double ox = from[0] + (i + 0.5) * spacing[0] - x, oy = from[1] + (j + 0.5) * spacing[1] - y,
                       oz = from[2] + (k + 0.5) * spacing[2] - z;
          if (ox * ox + oy * oy + oz * oz <= r * r) solid[static_cast<std::size_t>(i + kPoints * (j + kPoints * k))] = 1;
        }
      }
    }
  });
  return static_cast<double>(std::count(solid.begin(), solid.end(), 1)) / static_cast<double>(solid.size());
}

}  // namespace regolab::protocol
