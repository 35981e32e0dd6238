#include "worker/output/result_json.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "digest/sha256.h"
#include "vocab/units.h"
#include "worker/output/job_json.h"
#include "worker/output/number_text.h"

namespace regolab {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Measurement& m) {
  const DoorUnit door = door_unit(m.unit);
  Json json{{"id", m.id},
            {"value", m.value},
            {"unit", m.unit},
            {"standard_error", m.standard_error ? Json(*m.standard_error) : Json(nullptr)},
            {"shown", shown_value(m.value, door.factor)},
            {"shown_unit", door.name},
            {"definition", m.definition}};
  return json;
}

Json to_json(const Curve& c) {
  return {{"id", c.id}, {"test", c.test},     {"x_name", c.x_name}, {"x_unit", c.x_unit},
          {"x", c.x},   {"y_name", c.y_name}, {"y_unit", c.y_unit}, {"y", c.y}};
}

template <class T>
Json to_list(const std::vector<T>& items) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(to_json(item));
  return list;
}

double number(const Json& json) { return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>(); }

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& item : json) values.push_back(number(item));
  return values;
}

std::vector<Measurement> measurements(const Json& list) {
  std::vector<Measurement> all;
  for (const Json& json : list) {
    Measurement m;
    m.id = json.at("id");
    m.value = number(json.at("value"));
    m.unit = json.at("unit");
    if (!json.at("standard_error").is_null()) m.standard_error = json.at("standard_error").get<double>();
    m.definition = json.at("definition");
    all.push_back(std::move(m));
  }
  return all;
}

std::vector<Curve> curves(const Json& list) {
  std::vector<Curve> all;
  for (const Json& json : list) {
    all.push_back({.id = json.at("id"),
                   .test = json.at("test"),
                   .x_name = json.at("x_name"),
                   .x_unit = json.at("x_unit"),
                   .y_name = json.at("y_name"),
                   .y_unit = json.at("y_unit"),
                   .x = numbers(json.at("x")),
                   .y = numbers(json.at("y"))});
  }
  return all;
}

}  // namespace

std::optional<StageEnd> end_named(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(StageEnd::kCancelled); ++i) {
    if (name_of(static_cast<StageEnd>(i)) == name) return static_cast<StageEnd>(i);
  }
  return std::nullopt;
}

Json stage_to_json(const FinishedStage& stage) {
  Json json{{"stage", stage_name(stage.spec.kind)}, {"stage_key", stage_key(stage.spec)}};
  if (stage.spec.kind == StageKind::kStress) json["sigma3_Pa"] = stage.spec.confining_stress;
  if (stage.spec.kind == StageKind::kPenetration) json["plate"] = plate_text(stage.spec.plate);
  json["end"] = name_of(stage.result.end);
  json["reason"] = stage.result.reason;
  json["steps"] = stage.steps;
  json["wall_s"] = stage.wall_s;
  json["measurements"] = to_list(stage.result.measurements);
  json["numerics"] = to_list(stage.result.numerics);
  json["curves"] = to_list(stage.result.curves);
  return json;
}

Result<FinishedStage> stage_from_json(const Json& json, const StageSpec& spec) {
  try {  // exceptions are the JSON library's way to say that a key is absent or of another type
    return FinishedStage{.spec = spec,
                         .result = {.end = end_named(json.at("end").get<std::string>()).value(),
                                    .reason = json.at("reason"),
                                    .measurements = measurements(json.at("measurements")),
                                    .numerics = measurements(json.at("numerics")),
                                    .curves = curves(json.at("curves"))},
                         .steps = json.at("steps"),
                         .wall_s = json.at("wall_s")};
  } catch (const std::exception& problem) {
    return Error{Code::kDataLoss,
                 std::string("stage record is damaged (") + problem.what() + ") delete it to run the stage again"};
  }
}

std::string result_json(const Job& job, const std::vector<FinishedStage>& stages) {
  StageEnd end = StageEnd::kCompleted;
  std::string reason;
  Json list = Json::array();
  for (const FinishedStage& stage : stages) {
    if (end == StageEnd::kCompleted && stage.result.end != StageEnd::kCompleted) {
      end = stage.result.end;
      reason = stage.result.reason;
    }
    list.push_back(stage_to_json(stage));
  }
  const Json document{{"format", "regolab.result/1"},
                      {"program", {{"name", "regolab-worker"}, {"version", program_version()}}},
                      {"physics_version", kPhysicsVersion},
                      {"job_key", job_key(job)},
                      {"job", job_json(job)},
                      {"end", name_of(end)},
                      {"reason", reason},
                      {"stages", std::move(list)}};
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace regolab
