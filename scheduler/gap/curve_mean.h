/// Means of a curve over an interval.
#pragma once
#include <optional>

#include "scheduler/gap/readings.h"

namespace regolab::gap {

struct CurveMean {
  double value = 0;
  double standard_error = 0;  ///< errors fully correlated along the curve: the mean of the errors
};

/// Integral over [low, high] of the straight lines between points, divided by the length. Nothing when the curve does not reach
/// over it (a tenth of the interval may lack at either end) or has fewer than two points in it.
std::optional<CurveMean> mean_over(const CurveReading& curve, double low, double high);

/// A profile whose points are the middles of columns: the first stands half a column from the wall, the last half one from the edge.
struct ProfileMean {
  double length = 0;  ///< wall to edge
  CurveMean height;
};
std::optional<ProfileMean> mean_height(const CurveReading& profile);

}  // namespace regolab::gap
