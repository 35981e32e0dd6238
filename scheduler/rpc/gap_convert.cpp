#include "scheduler/rpc/gap_convert.h"

#include "scheduler/rpc/analysis_convert.h"
#include "vocab/units.h"

namespace regolab {

v1::FeatureValue to_proto(const gap::Feature& feature) {
  const gap::FeatureInfo info = *gap::feature_info(feature.id);
  const DoorUnit door = door_unit(info.unit);
  v1::FeatureValue out;
  out.set_id(feature.id);
  out.set_label(info.label);
  out.set_group(feature.group.text());
  out.set_value(feature.value);
  out.set_standard_error(feature.standard_error);
  out.set_logarithm(info.kind == gap::Kind::kLog);
  out.set_assumed(feature.assumed);
  out.set_repeats(static_cast<std::uint32_t>(feature.repeats));
  out.set_unit(std::string(door.name));
  out.set_shown(info.physical(feature.value) * door.factor);
  out.set_shown_error(info.physical_error(feature.value, feature.standard_error) * door.factor);
  return out;
}

v1::ImportReply to_proto(const gap::ObservationSet& set) {
  v1::ImportReply out;
  out.set_name(set.name);
  out.set_scalars(static_cast<std::uint32_t>(set.scalars.size()));
  out.set_curves(static_cast<std::uint32_t>(set.curves.size()));
  for (const gap::Feature& feature : gap::features_of(gap::readings_of(set))) *out.add_features() = to_proto(feature);
  for (const gap::Unused& unused : set.unused) {
    auto& entry = *out.add_unused();
    entry.set_id(unused.id);
    entry.set_why(unused.why);
  }
  for (const Diagnostic& warning : set.warnings) *out.add_warnings() = to_proto(warning);
  out.set_few(set.few);
  out.set_assumed(set.assumed);
  return out;
}

}  // namespace regolab
