#include "scheduler/rpc/functions_convert.h"

namespace regolab {
namespace {

v1::FitQuality to_proto(const surrogate::FitQuality& quality) {
  v1::FitQuality out;
  out.set_rows(static_cast<std::uint32_t>(quality.rows));
  if (quality.r) out.set_r(*quality.r);
  if (quality.r2) out.set_r2(*quality.r2);
  out.set_rms(quality.rms);
  out.set_relative(quality.relative);
  return out;
}

v1::FunctionGroup to_proto(const surrogate::FunctionGroup& group) {
  v1::FunctionGroup out;
  out.set_name(group.name);
  for (const int point : group.points) out.add_points(point);
  if (group.r) out.set_r(*group.r);
  if (group.r_pooled) out.set_r_pooled(*group.r_pooled);
  out.set_article_r(group.article_r);
  return out;
}

v1::PredictionFunction to_proto(const surrogate::FunctionReport& function) {
  v1::PredictionFunction out;
  out.set_name(function.name);
  out.set_problem(function.problem);
  if (!function.problem.empty()) return out;
  for (const std::string& input : function.inputs) out.add_inputs(input);
  out.set_hidden(surrogate::kHiddenUnits);
  out.set_weights(static_cast<std::uint32_t>(function.weights));
  out.set_weights_in_use(function.weights_in_use);
  out.set_starts(static_cast<std::uint32_t>(function.effort.starts));
  out.set_chosen_start(static_cast<std::uint32_t>(function.chosen_start));
  out.set_members(static_cast<std::uint32_t>(function.effort.members));
  out.set_folds(static_cast<std::uint32_t>(function.effort.folds));
  for (const surrogate::FunctionGroup& group : function.groups) *out.add_groups() = to_proto(group);
  for (const surrogate::OutputReport& output : function.outputs) {
    v1::FunctionOutput& line = *out.add_outputs();
    line.set_response(output.response);
    line.set_unit(output.unit);
    *line.mutable_left_out() = to_proto(output.left_out);
    for (const surrogate::FitQuality& group : output.groups) *line.add_groups() = to_proto(group);
  }
  return out;
}

}  // namespace

v1::TrainFunctionsReply to_proto(const surrogate::FunctionsReport& report) {
  v1::TrainFunctionsReply out;
  out.set_experiment(report.experiment);
  out.set_seed(report.seed);
  for (const surrogate::FunctionReport& function : report.functions) *out.add_functions() = to_proto(function);
  for (const std::string& note : report.notes) out.add_notes(note);
  return out;
}

}  // namespace regolab
