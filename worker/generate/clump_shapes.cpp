#include "worker/generate/clump_shapes.h"

#include <algorithm>
#include <cmath>

namespace regolab::generate {
namespace {

double between(double low, double high, double u) { return low + (high - low) * u; }

/// Height over the line of two touching spheres of radius r1 at which a sphere of radius ri touches both.
double saddle(double r1, double ri) { return std::sqrt((r1 + ri) * (r1 + ri) - r1 * r1); }

double farthest_after_shift(const Clump& clump, double shift) {
  double far = 0;
  for (std::size_t i = 0; i < clump.radius.size(); ++i) {
    const auto& c = clump.centre[i];
    far = std::max(far, std::hypot(c[0], c[1] + shift, c[2]) + clump.radius[i]);
  }
  return far;
}

/// Shift along y that brings the farthest point nearest: a convex function, by golden section to 1e-12 of r.
double centring_shift(const Clump& clump, double r) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = -0.3 * r, high = 0.3 * r;
  while (high - low > 1e-12 * r) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    if (farthest_after_shift(clump, a) < farthest_after_shift(clump, b)) high = b;
    else low = a;
  }
  return 0.5 * (low + high);
}

}  // namespace

AxisRatios axis_ratios(double u_b, double u_c, double u_cb) {
  return {between(0.751, 0.805, u_b), between(0.566, 0.611, u_c), between(0.750, 0.798, u_cb)};
}

Clump two_element(double r, TwoKind kind, const AxisRatios& ratios) {
  const double short_over_long = kind == TwoKind::kAC   ? ratios.c_over_a
                                 : kind == TwoKind::kAB ? ratios.b_over_a
                                                        : ratios.c_over_b;
  const double r1 = r * short_over_long;  // half of S = 2r * ratio
  const double r2 = r - r1;
  return {{{0, r - r1, 0}, {0, -r + r2, 0}}, {r1, r2}};
}

Clump four_element(double r, const AxisRatios& ratios) {
  const double b = 2 * r * ratios.b_over_a, c = 2 * r * ratios.c_over_a;
  const double r1 = 0.5 * r;
  const double r3 = (r1 * r1 + b * b) / (2 * b) - r1;
  const double r4 = (r1 * r1 + c * c) / (2 * c) - r1;
  Clump clump{{{r1, 0, 0}, {-r1, 0, 0}, {0, saddle(r1, r3), 0}, {0, 0, saddle(r1, r4)}}, {r1, r1, r3, r4}};
  const double shift = centring_shift(clump, r);
  for (auto& centre : clump.centre) centre[1] += shift;
  return clump;
}

Clump six_element(double r, const AxisRatios& ratios) {
  const double b = 2 * r * ratios.b_over_a, c = 2 * r * ratios.c_over_a;
  const double r1 = 0.25 * b;
  const double r3 = r * r / (2 * r + 2 * r1);
  const double r5 = 0.25 * c * c / (2 * r1 + c);
  const double h3 = saddle(r1, r3), h5 = saddle(r1, r5);
  return {{{0, r1, 0}, {0, -r1, 0}, {h3, 0, 0}, {-h3, 0, 0}, {0, 0, h5}, {0, 0, -h5}}, {r1, r1, r3, r3, r5, r5}};
}

double farthest_point(const Clump& clump) { return farthest_after_shift(clump, 0); }

}  // namespace regolab::generate
