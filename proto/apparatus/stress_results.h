/// The stress test's curve, and the numbers and curves that are made of it.
#pragma once
#include <string>
#include <vector>

#include "vocab/measurement.h"

namespace regolab {

/// Means over one interval of axial strain. Stresses [Pa].
struct StressSample {
  double strain = 0;      ///< at the end of the interval
  double top = 0, bottom = 0, lateral_x = 0, lateral_y = 0;
  double volumetric_strain = 0;  ///< at its end, contraction positive
  double unbalanced = 0;  ///< unbalanced force ratio at its end

  double sigma1() const { return 0.5 * (top + bottom); }
  double sigma3() const { return 0.5 * (lateral_x + lateral_y); }
  template <class A>
  void archive(A& ar) { ar(strain, top, bottom, lateral_x, lateral_y, volumetric_strain, unbalanced); }
};

/// "_at_sigma3_1.25kPa": what the ids of a stress test end in.
std::string stress_id(double sigma3);

/// Numbers and curves of a shear run; ids carry sigma3. `end_strain` closes the last quarter.
void add_stress_results(const std::vector<StressSample>& samples, double sigma3, double end_strain, double void_ratio0,
                        StageResult& out);

}  // namespace regolab
