#include "scheduler/gap/observation.h"

#include <algorithm>

namespace regolab::gap {

std::vector<double> ObservationSet::sigma3() const {
  std::vector<double> all;
  for (const Scalar& s : scalars) all.push_back(s.sigma3);
  for (const MeasuredCurve& c : curves) all.push_back(c.sigma3);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < 1e-6 * b; }), all.end());
  std::erase(all, 0.0);
  return all;
}

}  // namespace regolab::gap
