#include "client/json_view.h"

#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>

#include "client/number_text.h"
#include "client/views/names.h"
#include "vocab/measurement.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

template <class Repeated>
Json list_of(const Repeated& texts) {
  Json list = Json::array();
  for (const auto& text : texts) list.push_back(text);
  return list;
}

Json label(const std::string& text) {
  const auto number = as_number(text);
  return number ? Json(*number) : Json(text);
}

Json counts(const pb::JobCounts& jobs) {
  return {{"blocked", jobs.blocked()}, {"ready", jobs.ready()},
          {"running", jobs.running()}, {"succeeded", jobs.succeeded()},
          {"failed", jobs.failed()},   {"cancelled", jobs.cancelled()},
          {"skipped", jobs.skipped()}, {"quarantined", jobs.quarantined()},
          {"reused", jobs.reused()},   {"unphysical", jobs.unphysical()}};
}

Json json_of(const pb::LevelStatistics& level) {
  return {{"level", label(level.label())},
          {"runs", level.runs()},
          {"K_sum", level.sum()},
          {"k_mean", level.mean()},
          {"half_width_95", level.has_half_width_95() ? Json(level.half_width_95()) : Json()}};
}

Json json_of(const pb::FactorAnalysis& factor) {
  Json levels = Json::array();
  for (const auto& level : factor.levels()) levels.push_back(json_of(level));
  return {{"name", factor.name()},
          {"unit", factor.unit()},
          {"rank", factor.rank()},
          {"R", factor.range()},
          {"R_standard_error", factor.has_range_standard_error() ? Json(factor.range_standard_error()) : Json()},
          {"highest_level", label(factor.highest_level())},
          {"lowest_level", label(factor.lowest_level())},
          {"sum_of_squares", factor.sum_of_squares()},
          {"degrees_of_freedom", factor.degrees_of_freedom()},
          {"F", factor.has_f() ? Json(factor.f()) : Json()},
          {"p", factor.has_p() ? Json(factor.p()) : Json()},
          {"R_without_one_run_min", factor.leave_one_out_range_min()},
          {"R_without_one_run_max", factor.leave_one_out_range_max()},
          {"leaning_on_point", factor.leaning_on_point()},
          {"fragile", factor.fragile()},
          {"fragile_why", factor.fragile_why()},
          {"levels", levels}};
}

Json json_of(const pb::ResponseAnalysis& analysis) {
  Json factors = Json::array();
  for (const auto& factor : analysis.factors()) factors.push_back(json_of(factor));
  const std::string id = analysis.response();
  return {{"response", id},
          {"unit", analysis.unit()},
          {"runs_used", analysis.runs_used()},
          {"missing", list_of(analysis.missing())},
          {"mean", analysis.mean()},
          {"residual_standard_deviation", analysis.residual_standard_deviation()},
          {"error_degrees_of_freedom", analysis.error_degrees_of_freedom()},
          {"seed_standard_deviation",
           analysis.has_seed_standard_deviation() ? Json(analysis.seed_standard_deviation()) : Json()},
          {"factors", factors},
          {"notes", list_of(analysis.notes())}};
}

Json row_of(const pb::ResultsReply& results, const pb::ResultRow& row) {
  Json out{{"point", row.point()}, {"seed", row.seed()}};
  for (int f = 0; f < results.factors_size(); ++f) out[column_of(results.factors(f))] = label(label_of(results, row, f));
  Json missing = Json::object();
  for (const auto& response : results.responses()) {
    const auto value = row.value_si().find(response.id());
    out[column_of(response)] =
        value == row.value_si().end() ? Json() : Json(value->second * door_unit(response.unit_si()).factor);
    const auto why = row.missing().find(response.id());
    if (why != row.missing().end()) missing[response.id()] = why->second;
  }
  out["missing"] = missing;
  return out;
}

Json json_of(const pb::FitQuality& quality) {
  return {{"rows", quality.rows()},
          {"R", quality.has_r() ? Json(quality.r()) : Json()},
          {"R2", quality.has_r2() ? Json(quality.r2()) : Json()},
          {"rms", quality.rms()},
          {"relative", quality.relative()}};
}

Json json_of(const pb::PredictionFunction& function) {
  Json groups = Json::array();
  for (const auto& group : function.groups()) {
    groups.push_back({{"name", group.name()},
                      {"points", list_of(group.points())},
                      {"R", group.has_r() ? Json(group.r()) : Json()},
                      {"R_pooled", group.has_r_pooled() ? Json(group.r_pooled()) : Json()},
                      {"R_article", group.article_r()}});
  }
  Json outputs = Json::array();
  for (const auto& output : function.outputs()) {
    Json line{{"response", output.response()}, {"unit", output.unit()}, {"left_out", json_of(output.left_out())}};
    for (int g = 0; g < output.groups_size(); ++g) line[function.groups(g).name()] = json_of(output.groups(g));
    outputs.push_back(line);
  }
  return {{"name", function.name()},
          {"problem", function.problem()},
          {"inputs", list_of(function.inputs())},
          {"hidden", function.hidden()},
          {"weights", function.weights()},
          {"weights_in_use", function.weights_in_use()},
          {"starts", function.starts()},
          {"chosen_start", function.chosen_start()},
          {"members", function.members()},
          {"folds", function.folds()},
          {"groups", groups},
          {"outputs", outputs}};
}

Json json_of(const google::protobuf::RepeatedPtrField<pb::Measurement>& measurements) {
  Json out = Json::object();
  for (const auto& m : measurements) {
    const DoorUnit door = door_unit(m.unit_si());
    out[m.id() + unit_suffix(door.name)] = m.value_si() * door.factor;
    if (m.has_standard_error_si())
      out[m.id() + "_standard_error" + unit_suffix(door.name)] = m.standard_error_si() * door.factor;
  }
  return out;
}

/// The specification exactly as the wire has it: field names with SI units, and zeros written out.
Json spec_of(const pb::StageSpec& spec) {
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(spec, &text, options).ok()) return {};
  return Json::parse(text, nullptr, false);
}

}  // namespace

Json document(const std::string& verb) { return {{"format", "regolab." + verb + "/1"}}; }

Json json_of(const std::vector<Diagnostic>& diagnostics) {
  Json list = Json::array();
  for (const auto& d : diagnostics) {
    list.push_back(
        {{"file", d.file}, {"line", d.line}, {"column", d.column}, {"text", d.text}, {"source_line", d.source_line}});
  }
  return list;
}

Json json_of(const pb::DesignSummary& summary) {
  return {{"name", summary.name()},
          {"array", summary.array()},
          {"points", summary.points()},
          {"seeds", summary.seeds()},
          {"strength", summary.strength()},
          {"balanced", summary.balanced()},
          {"error_degrees_of_freedom", summary.error_degrees_of_freedom()},
          {"factor_columns", list_of(summary.factor_columns())},
          {"profile", summary.profile()},
          {"tests", list_of(summary.tests())},
          {"jobs", summary.jobs()},
          {"jobs_stored", summary.jobs_stored()},
          {"dem_jobs", summary.dem_jobs()},
          {"notes", list_of(summary.notes())}};
}

Json json_of(const pb::ExperimentStatus& status) {
  Json running = Json::array();
  for (const auto& job : status.running()) {
    running.push_back({{"worker", job.worker()},
                       {"job", job.job()},
                       {"point", job.point()},
                       {"seed", job.seed()},
                       {"stage", job.stage()},
                       {"phase", job.phase()},
                       {"fraction", job.fraction()},
                       {"sphere_steps_per_s", job.sphere_steps_per_s()}});
  }
  return {{"experiment", status.experiment()},
          {"name", status.name()},
          {"state", status.state()},
          {"jobs", counts(status.jobs())},
          {"workers", status.workers()},
          {"elapsed_s", status.elapsed_s()},
          {"remaining_s", status.remaining_s() < 0 ? Json() : Json(status.remaining_s())},
          {"created_unix_ms", status.created_unix_ms()},
          {"running", running},
          {"failures", list_of(status.failures())},
          {"summary", json_of(status.summary())}};
}

Json json_of(const pb::WatchEvent& event) {
  return {{"seq", event.seq()},
          {"text", event.text()},
          {"state", event.status().state()},
          {"jobs", counts(event.status().jobs())}};
}

Json json_of(const pb::RangeReply& range) {
  Json list = Json::array();
  for (const auto& response : range.responses()) list.push_back(json_of(response));
  return list;
}

void add_results(const pb::ResultsReply& results, Json& document) {
  document["experiment"] = results.experiment();
  document["name"] = results.name();
  document["array"] = results.array();
  document["factors"] = Json::array();
  for (const auto& factor : results.factors()) {
    Json levels = Json::array();
    for (const auto& text : factor.levels()) levels.push_back(label(text));
    document["factors"].push_back(
        {{"name", factor.name()}, {"unit", factor.unit()}, {"column", column_of(factor)}, {"levels", levels}});
  }
  document["responses"] = Json::array();
  for (const auto& response : results.responses()) {
    document["responses"].push_back(
        {{"id", response.id()}, {"unit", door_unit(response.unit_si()).name}, {"column", column_of(response)}});
  }
  document["rows"] = Json::array();
  for (const auto& row : results.rows()) document["rows"].push_back(row_of(results, row));
}

void add_check(const pb::CheckArticleReply& check, Json& document) {
  document["entries"] = Json::array();
  for (const auto& entry : check.entries()) {
    document["entries"].push_back({{"table", entry.table()},
                                   {"entry", entry.entry()},
                                   {"unit", entry.unit()},
                                   {"printed", entry.printed()},
                                   {"recomputed", entry.recomputed()},
                                   {"agrees", entry.agrees()},
                                   {"explanation", entry.explanation()}});
  }
  document["findings"] = list_of(check.findings());
}

void add_comparison(const pb::CompareArticleReply& comparison, Json& document) {
  document["experiment"] = comparison.experiment();
  document["responses"] = Json::array();
  for (const auto& response : comparison.responses()) {
    Json cells = Json::array();
    for (const auto& cell : response.cells()) {
      cells.push_back({{"test", cell.test()},
                       {"article", cell.article()},
                       {"ours", cell.has_ours() ? Json(cell.ours()) : Json()},
                       {"ours_standard_error", cell.has_ours_standard_error() ? Json(cell.ours_standard_error()) : Json()},
                       {"missing", cell.missing()}});
    }
    document["responses"].push_back({{"response", response.response()},
                                     {"unit", response.unit()},
                                     {"tests_compared", response.tests_compared()},
                                     {"correlation", response.correlation()},
                                     {"mean_error", response.mean_error()},
                                     {"mean_absolute_relative_error", response.mean_absolute_relative_error()},
                                     {"leading_factors_article", list_of(response.leading_factors_article())},
                                     {"leading_factors_ours", list_of(response.leading_factors_ours())},
                                     {"cells", cells}});
  }
  document["notes"] = list_of(comparison.notes());
}

void add_functions(const pb::TrainFunctionsReply& trained, Json& document) {
  document["experiment"] = trained.experiment();
  document["seed"] = trained.seed();
  document["functions"] = Json::array();
  for (const auto& function : trained.functions()) document["functions"].push_back(json_of(function));
  document["notes"] = list_of(trained.notes());
}

Json json_of(const pb::ExportItem& item) {
  Json out = document("stage");
  out["point"] = item.point();
  out["seed"] = item.seed();
  out["state"] = item.state();
  out["stage_key"] = item.stage_key();
  out["spec_si"] = spec_of(item.spec());
  out["end"] = name_of(static_cast<StageEnd>(item.result().end()));
  out["reason"] = item.result().reason();
  out["measurements"] = json_of(item.result().measurements());
  out["numerics"] = json_of(item.result().numerics());
  return out;
}

std::string text_of(const Json& document) { return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string line_of(const Json& document) { return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace regolab::client
