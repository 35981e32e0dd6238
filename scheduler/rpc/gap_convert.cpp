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

v1::FittedFeature to_proto(const gap::FeatureFit& fit) {
  const gap::FeatureInfo info = *gap::feature_info(fit.measured.id);
  const DoorUnit door = door_unit(info.unit);
  v1::FittedFeature out;
  const auto shown = [&](double value) { return info.physical(value) * door.factor; };
  const auto shown_error = [&](double value, double error) { return info.physical_error(value, error) * door.factor; };
  out.set_id(info.id), out.set_label(info.label), out.set_group(info.group.text()), out.set_unit(std::string(door.name)), out.set_sigma3_pa(info.group.sigma3);
  out.set_measured(shown(fit.measured.value)), out.set_measured_error(shown_error(fit.measured.value, fit.measured.standard_error));
  out.set_base(shown(fit.base.value)), out.set_base_error(shown_error(fit.base.value, fit.base.standard_error));
  if (fit.repaired) out.set_repaired(shown(fit.repaired->value)), out.set_repaired_error(shown_error(fit.repaired->value, fit.repaired->standard_error));
  return out;
}

void add_where(const std::vector<gap::GroupGap>& where, v1::Diagnosis& out) {
  for (const gap::GroupGap& g : where) {
    auto& group = *out.add_where();
    group.set_group(g.group.text()), group.set_feature(g.feature), group.set_text(g.text), group.set_shift_pct(g.shift_pct);
    group.set_z(g.z), group.set_p(g.p), group.set_p_adjusted(g.p_adjusted);
  }
}

v1::Diagnosis to_proto(const gap::Diagnosis& d) {
  v1::Diagnosis out;
  out.set_verdict(std::string(gap::name_of(d.verdict)));
  for (const std::string& name : d.classes) out.add_classes(name);
  for (const gap::Weighed& m : d.models) {
    auto& model = *out.add_models();
    model.set_model(m.model), model.set_cause(m.cause), model.set_probability(m.probability), model.set_log_z(m.log_z), model.set_log_z_error(m.log_z_error);
    for (const gap::Strength& s : m.strength) {
      auto& strength = *model.add_strength();
      strength.set_effect(s.effect), strength.set_unit_si(s.unit), strength.set_median(s.median), strength.set_low_05(s.low), strength.set_high_95(s.high);
    }
    for (const gap::Draw& d_of : m.draws) {
      auto& draw = *model.add_draws();
      for (const double value : d_of.values) draw.add_values_si(value);
      for (const double strength : d_of.strength) draw.add_strengths_si(strength);
    }
  }
  add_where(d.where, out);
  for (const gap::Isolability& i : d.isolability) {
    auto& one = *out.add_isolability();
    one.set_effect(i.effect), one.set_sigma(i.sigma), one.set_twin(i.twin), one.set_cosine(i.cosine);
  }
  for (const gap::NextTest& t : d.next) {
    auto& test = *out.add_next_tests();
    test.set_test(t.test), test.set_eig_error(t.nats_error), test.set_hours(t.hours);
    if (t.nats) test.set_eig_nats(*t.nats);
    for (const std::string& pair : t.splits) test.add_splits(pair);
  }
  out.set_open_nats(d.open);
  out.set_adequacy_p(d.adequacy), out.set_adequacy_threshold(d.adequacy_threshold);
  out.set_features(static_cast<std::uint32_t>(d.features));
  for (const std::string& warning : d.warnings) out.add_warnings(warning);
  return out;
}

}  // namespace regolab
