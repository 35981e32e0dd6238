/// Clusters of 2, 4 and 6 tangent spheres that stand in for a parent sphere [article Sec. 2.3, Table 1].
///
/// RECONSTRUCTED: the printed table lost minus signs and roots. They follow from demanding that touching spheres touch and
/// that the extents are a, b, c: r2 = r - r1; h_i = sqrt((r1 + r_i)^2 - r1^2). Tangency and extents are tested over many draws.
#pragma once
#include <vector>

#include "worker/dem/bodies.h"

namespace regolab::generate {

/// The axes that a two-sphere cluster shows, long over short.
enum class TwoKind { kAC, kAB, kBC };

/// Spheres relative to the parent centre; scale of the parent radius.
struct Clump {
  std::vector<dem::Vec3> centre;  // [n] [m]
  std::vector<double> radius;     // [n] [m]
};

/// Axis ratios: b = a * b_over_a with R(0.751, 0.805); c = a * c_over_a with R(0.566, 0.611); a = 2 * parent radius.
struct AxisRatios {
  double b_over_a;
  double c_over_a;
  double c_over_b;  ///< R(0.750, 0.798), two-sphere kind b/c only
};
/// The measured ranges, at u in [0, 1) each.
AxisRatios axis_ratios(double u_b, double u_c, double u_cb);

/// Long axis 2r along y. The b/c kind is as long as the others ("control axis b = 2r").
Clump two_element(double parent_radius, TwoKind kind, const AxisRatios& ratios);

/// Spheres 1, 2 along x, 3 towards +y, 4 towards +z. DEVIATION: shifted along y so that its smallest enclosing ball stands on
/// the parent centre; as printed it sticks out of the parent by up to 11 % and neighbours may overlap.
Clump four_element(double parent_radius, const AxisRatios& ratios);

/// Spheres 1, 2 along y, 3, 4 along x, 5, 6 along z.
Clump six_element(double parent_radius, const AxisRatios& ratios);

/// Distance from the parent centre to the farthest point [m].
double farthest_point(const Clump& clump);

}  // namespace regolab::generate
