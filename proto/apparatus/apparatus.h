/// What an apparatus makes of a stress test: a frame that gives, a specimen that is not yet seated, a load cell that errs. No DEM: the
/// same function serves the worker's results and stored ones.
#pragma once
#include <vector>

#include "apparatus/stress_results.h"
#include "vocab/effects.h"
#include "vocab/result.h"

namespace regolab {

struct Apparatus {
  double frame_compliance = 0;  ///< axial strain per axial stress [1/Pa]
  double seating = 0;           ///< axial strain read before the plate meets the specimen
  double load_cell_offset = 0;  ///< [Pa]
  double load_cell_gain = 0;    ///< relative error

  bool ideal() const { return frame_compliance == 0 && seating == 0 && load_cell_offset == 0 && load_cell_gain == 0; }
};
Apparatus apparatus_of(const EffectSet& effects);

/// strain + (sigma1 - sigma1 at the start) compliance + seating, with a foot at strain 0 where the plate still travels; top and bottom
/// stress times (1 + gain) + offset. Lateral stress and volumetric strain have instruments of their own and stay.
std::vector<StressSample> as_measured(const std::vector<StressSample>& samples, const Apparatus& apparatus);

/// A completed stress stage of an ideal apparatus, as this one shows it: curves changed, numbers recomputed from them. kInvalidArgument
/// when the curves of that sigma3 are not all there.
Result<StageResult> as_measured(const StageResult& ideal, double sigma3, double end_strain, const Apparatus& apparatus);

}  // namespace regolab
