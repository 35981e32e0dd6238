/// Cohesion and friction angle as the stresses they mean: sigma1 = sigma3 N + 2 c sqrt(N), N = tan(45 deg + phi/2)^2 [Mohr and Coulomb].
#pragma once
#include <array>
#include <optional>
#include <span>

#include "scheduler/gap/features.h"

namespace regolab::gap {

struct StrengthLine {
  std::array<Feature, 2> ends;  ///< sigma1_ratio at two confining stresses
  double correlation = 0;       ///< of their errors: both come from the same two numbers
};

/// From the features `strength_cohesion` and `strength_friction_angle`, whose errors are taken as independent. Two numbers are two features: the
/// line between them says nothing more. levels: where a bank has sigma1, ascending [Pa]; fitted_over: [Pa], may be empty. The ends are the
/// lowest and the highest level within its range, or of all where fewer than two are. Nothing without both features, without two levels,
/// or where the line is not above 0.
std::optional<StrengthLine> strength_line(std::span<const Feature> features, std::span<const double> levels, std::span<const double> fitted_over);

}  // namespace regolab::gap
