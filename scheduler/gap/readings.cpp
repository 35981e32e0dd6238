#include "scheduler/gap/readings.h"

#include <algorithm>
#include <cmath>

#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

/// None of three that stood does not make the share 0 ± 0: its error is at least that of n throws with odds (k + 1)/(n + 2).
double error_of_share(double share, double standard_error, int n) {
  const double odds = (share * n + 1) / (n + 2);
  return std::max(standard_error, std::sqrt(odds * (1 - odds) / n));
}

}  // namespace

Readings readings_of(const ObservationSet& set) {
  Readings out;
  for (const Scalar& s : set.scalars) out.scalars[s.id] = {s.value, s.standard_error, s.seeds, s.assumed};
  if (const auto stood = out.scalars.find("repose_column_stood"); stood != out.scalars.end()) {
    Reading& r = stood->second;
    r.standard_error = error_of_share(r.value, r.standard_error, r.repeats);
  }
  for (const MeasuredCurve& c : set.curves) out.curves[c.id] = {c.x, c.y, c.y_standard_error, c.seeds, c.assumed};
  return out;
}

void add_readings(const StageResult& result, Readings& readings) {
  if (result.end != StageEnd::kCompleted) return;
  for (const Measurement& m : result.measurements) {
    if (const auto id = scalar_id(m.id); id && std::isfinite(m.value)) readings.scalars[id->normal] = {.value = m.value};
  }
  for (const Curve& c : result.curves) {
    if (const auto id = curve_id(c.id); id && c.x.size() == c.y.size()) readings.curves[id->normal] = {.x = c.x, .y = c.y, .y_standard_error = {}};
  }
}

}  // namespace regolab::gap
