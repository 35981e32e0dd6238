#include "scheduler/rpc/surrogate_convert.h"

#include "scheduler/surrogate/material.h"
#include "vocab/units.h"

namespace regolab {
namespace {

v1::ModelInput to_proto(const surrogate::InputColumn& column) {
  v1::ModelInput out;
  out.set_name(column.name);
  out.set_unit(surrogate::input_unit(column));
  for (const std::string& label : column.labels) out.add_labels(label);
  out.set_low(column.low * surrogate::input_factor(column));
  out.set_high(column.high * surrogate::input_factor(column));
  return out;
}

v1::ModelSkill to_proto(const surrogate::ResponseModel& r) {
  const DoorUnit door = door_unit(r.unit);
  v1::ModelSkill out;
  out.set_response(r.id);
  out.set_unit(std::string(door.name));
  out.set_points(r.skill.points);
  out.set_r(r.skill.r);
  out.set_r2(r.skill.r2);
  out.set_rms(r.skill.rms * door.factor);
  out.set_relative(r.skill.relative);
  out.set_coverage(r.skill.coverage);
  out.set_logarithm(r.logarithm);
  return out;
}

}  // namespace

v1::ModelSummary to_proto(const surrogate::Model& model, std::int64_t created_unix_ms) {
  v1::ModelSummary out;
  out.set_id(model.id);
  out.set_name(model.name);
  out.set_created_unix_ms(created_unix_ms);
  out.set_rows(static_cast<std::uint32_t>(model.data.rows.size()));
  for (const auto& column : model.data.columns) *out.add_inputs() = to_proto(column);
  for (const auto& response : model.responses) *out.add_skills() = to_proto(response);
  for (const auto& [name, text] : model.data.fixed) (*out.mutable_fixed())[name] = text;
  out.set_curves(model.curves.has_value());
  return out;
}

v1::Estimate to_proto(const surrogate::Estimate& e) {
  const DoorUnit door = door_unit(e.unit);
  v1::Estimate out;
  out.set_response(e.id);
  out.set_unit(std::string(door.name));
  out.set_value(e.value * door.factor);
  out.set_low(e.low * door.factor);
  out.set_high(e.high * door.factor);
  out.set_mean_low(e.mean_low * door.factor);
  out.set_mean_high(e.mean_high * door.factor);
  return out;
}

}  // namespace regolab
