#include "scheduler/gap/observation_end.h"

#include "scheduler/gap/features.h"
#include "scheduler/gap/quantities.h"

namespace regolab::gap {

Read<ObservationSet> finished(std::optional<ObservationSet> set, Report& report, Report& warnings) {
  if (set && report.empty()) {
    const std::size_t features = features_of(readings_of(*set)).size();
    if (features == 0) report.add({}, "nothing to compare (no observable or curve here makes a feature) known: " + known_scalars() + "; curves: " + known_curves());
    set->few = features < kFewFeatures;
    if (set->few) {
      warnings.add({}, "only " + std::to_string(features) + (features == 1 ? " feature" : " features") + " (below " + std::to_string(kFewFeatures) +
                           " no cause can be told from another) measure more: density, angle of repose, stress curves");
    }
    if (!set->protocol.gravity) warnings.add({}, "gravity is not stated (settling and repose depend on it) add nominal_protocol.gravity_m_s2");
    if (!set->material.nominal_max_size) warnings.add({}, "the largest grain size is not stated (it sets the specimen's scale) add material.nominal_max_size_cm");
    set->warnings = warnings.take();
  }
  Read<ObservationSet> out{.value = std::nullopt, .diagnostics = report.take()};
  if (out.diagnostics.empty()) out.value = std::move(set);
  return out;
}

}  // namespace regolab::gap
