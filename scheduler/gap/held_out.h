/// What a fit for confirmation does not see, chosen before it: some stress levels, by a hash of what was measured.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "scheduler/gap/observation.h"
#include "scheduler/gap/features.h"
#include "vocab/result.h"

namespace regolab::gap {

/// The confining stresses held out [Pa], ascending. `features`: measured ones that can be compared.
///
/// The rule: the stresses of the tests, ascending, are taken two by two, and of each two the SHA-256 of the features (id, value, error,
/// repeats) leaves out one; a last one without a partner stays in the fit, and so do density, fabric and slope. So the fit always keeps a low
/// and a high stress, nobody chooses, and nothing but the measurements decides.
///
/// kFailedPrecondition: fewer than two stresses, or fewer features left than a diagnosis can stand on.
Result<std::vector<double>> held_out_sigma3(std::span<const Feature> features);

/// The set without what was measured at these stresses.
ObservationSet without(ObservationSet set, std::span<const double> sigma3);

/// "stress 2.5 kPa, stress 10 kPa"
std::string held_out_text(std::span<const double> sigma3);

}  // namespace regolab::gap
