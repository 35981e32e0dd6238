#include "scheduler/gap/curve_mean.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace regolab::gap {
namespace {

/// Integral over [low, high] of the polygon through (x, y); level beyond its ends.
double integral(const std::vector<double>& x, const std::vector<double>& y, double low, double high) {
  double sum = std::max(0.0, std::min(high, x.front()) - low) * y.front() + std::max(0.0, high - std::max(low, x.back())) * y.back();
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double a = std::max(low, x[i - 1]), b = std::min(high, x[i]);
    if (!(b > a)) continue;
    const double slope = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    sum += (b - a) * (y[i - 1] + slope * (0.5 * (a + b) - x[i - 1]));
  }
  return sum;
}

bool sound(const CurveReading& curve) {
  return curve.x.size() >= 2 && curve.y.size() == curve.x.size() && (curve.y_standard_error.empty() || curve.y_standard_error.size() == curve.x.size());
}

CurveMean mean_between(const CurveReading& curve, double low, double high) {
  CurveMean out{.value = integral(curve.x, curve.y, low, high) / (high - low), .standard_error = 0};
  if (!curve.y_standard_error.empty()) out.standard_error = integral(curve.x, curve.y_standard_error, low, high) / (high - low);
  return out;
}

}  // namespace

std::optional<CurveMean> mean_over(const CurveReading& curve, double low, double high) {
  if (!sound(curve)) return std::nullopt;
  const double slack = 0.1 * (high - low);
  if (curve.x.front() > low + slack || curve.x.back() < high - slack) return std::nullopt;
  const auto inside = std::ranges::count_if(curve.x, [&](double x) { return x >= low - slack && x <= high + slack; });
  if (inside < 2) return std::nullopt;
  const CurveMean mean = mean_between(curve, std::max(low, curve.x.front()), std::min(high, curve.x.back()));
  return std::isfinite(mean.value) ? std::optional(mean) : std::nullopt;
}

std::optional<ProfileMean> mean_height(const CurveReading& profile) {
  if (!sound(profile)) return std::nullopt;
  const double length = profile.x.back() + profile.x.front();
  if (!(profile.x.front() >= 0) || !(length > 0)) return std::nullopt;
  const ProfileMean out{.length = length, .height = mean_between(profile, 0, length)};
  return std::isfinite(out.height.value) ? std::optional(out) : std::nullopt;
}

}  // namespace regolab::gap
