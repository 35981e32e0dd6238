#include <algorithm>
#include <cmath>

#include "worker/protocol/penetration.h"

namespace regolab::protocol {
namespace {

struct Mean {
  double value = 0, standard_error = 0;
};

/// Mean force over depths in (from, to]; the standard error is that of the scatter about a straight line, since the force rises on the
/// way, with samples one grain apart taken as independent.
Mean mean_between(const std::vector<PenetrationSample>& samples, double from, double to, double grain) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const PenetrationSample& s : samples) {
    if (s.depth <= from || s.depth > to) continue;
    const double d = s.depth - from;
    n += 1, x += d, y += s.force, xx += d * d, xy += d * s.force, yy += s.force * s.force;
  }
  if (n == 0) return {};
  const double sxx = xx - x * x / n, sxy = xy - x * y / n, syy = yy - y * y / n;
  const double scatter = std::max(0.0, syy - (sxx > 0 ? sxy * sxy / sxx : 0)) / std::max(1.0, n - 2);
  return {y / n, std::sqrt(scatter / std::max(1.0, (to - from) / grain))};
}

/// Force times depth, from the first touch on [J].
double work_of(const std::vector<PenetrationSample>& samples) {
  double work = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) work += samples[i].force * (samples[i].depth - samples[i - 1].depth);
  return work + (samples.size() > 1 ? samples[0].force * (samples[1].depth - samples[0].depth) : 0);
}

}  // namespace

void add_penetration_results(const std::vector<PenetrationSample>& samples, const PlateSize& plate, double height, double grain,
                             StageResult& out) {
  const std::string of = "_plate_" + plate_text(plate);
  const auto over = [&](double from, double to) { return mean_between(samples, from * height, to * height, grain); };
  const Mean deep = over(0.25, 0.5), shallow = over(0, 0.25);
  out.measurements = {
      {"penetration_force_0.25_0.50" + of, deep.value, "N", deep.standard_error,
       "mean upward force on the plate at depths of 0.25 to 0.5 of the bed's mean height"},
      {"penetration_force_0.00_0.25" + of, shallow.value, "N", shallow.standard_error,
       "mean upward force on the plate at depths to 0.25 of the bed's mean height"},
      {"penetration_work" + of, work_of(samples), "J", {}, "force integrated over depth, from the first touch to half the bed's mean height"},
  };
}

Curve penetration_curve(const std::vector<PenetrationSample>& samples, const PlateSize& plate) {
  Curve curve{"penetration_force_plate_" + plate_text(plate), "penetration", "depth", "m", "force", "N", {}, {}};
  for (const PenetrationSample& s : samples) {
    curve.x.push_back(s.depth);
    curve.y.push_back(s.force);
  }
  return curve;
}

}  // namespace regolab::protocol
