#include "scheduler/gap/strength_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

const Feature* find(std::span<const Feature> features, std::string_view id) {
  const auto found = std::ranges::find(features, id, &Feature::id);
  return found == features.end() ? nullptr : &*found;
}

/// ln(sigma1/sigma3) and its slopes.
struct At {
  double value, by_cohesion, by_angle;
};
At at(double c, double phi, double sigma3) {
  const double t = std::tan(0.25 * std::numbers::pi + 0.5 * phi), n = t * t, n_by_angle = t * (1 + n);
  const double ratio = n + 2 * c * t / sigma3;
  return {std::log(ratio), 2 * t / (sigma3 * ratio), n_by_angle * (1 + c / (sigma3 * t)) / ratio};
}

std::vector<double> within(std::span<const double> levels, std::span<const double> fitted_over) {
  std::vector<double> out(levels.begin(), levels.end());
  if (fitted_over.empty()) return out;
  const auto [low, high] = std::ranges::minmax(fitted_over);
  std::erase_if(out, [&](double level) { return level < low * (1 - 1e-9) || level > high * (1 + 1e-9); });
  return out.size() >= 2 ? out : std::vector<double>(levels.begin(), levels.end());
}

}  // namespace

std::optional<StrengthLine> strength_line(std::span<const Feature> features, std::span<const double> levels, std::span<const double> fitted_over) {
  const Feature *c = find(features, "strength_cohesion"), *phi = find(features, "strength_friction_angle");
  const auto usable = within(levels, fitted_over);
  if (!c || !phi || usable.size() < 2) return std::nullopt;
  StrengthLine out;
  std::array<At, 2> y;
  for (std::size_t k = 0; k < 2; ++k) {
    const double sigma3 = k == 0 ? usable.front() : usable.back();
    y[k] = at(c->value, phi->value, sigma3);
    if (!std::isfinite(y[k].value)) return std::nullopt;
    const double error = std::hypot(y[k].by_cohesion * c->standard_error, y[k].by_angle * phi->standard_error);
    out.ends[k] = {.id = "sigma1_ratio_" + kilopascals(sigma3), .group = {Test::kStress, sigma3, Part::kResidual}, .value = y[k].value, .standard_error = error,
                   .repeats = 1, .assumed = c->assumed || phi->assumed};
  }
  const double together = y[0].by_cohesion * y[1].by_cohesion * c->standard_error * c->standard_error +
                          y[0].by_angle * y[1].by_angle * phi->standard_error * phi->standard_error;
  const double size = out.ends[0].standard_error * out.ends[1].standard_error;
  out.correlation = size > 0 ? together / size : 0;
  return out;
}

}  // namespace regolab::gap
