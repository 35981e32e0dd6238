#include "scheduler/surrogate/model_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "digest/sha256.h"
#include "scheduler/surrogate/curves.h"
#include "scheduler/surrogate/fit.h"
#include "vocab/stage.h"

namespace regolab::surrogate {
namespace {

using Json = nlohmann::ordered_json;  // to write: keys as they stand here
using Parsed = nlohmann::json;          // to read: keys found fast
constexpr std::string_view kFormat = "regolab.model/1";

Json hyper_json(const Hyperparameters& h) {
  return {{"log_length", h.log_length}, {"log_signal", h.log_signal}, {"log_trend", h.log_trend}, {"log_noise", h.log_noise}};
}

Hyperparameters hyper_of(const Parsed& j) {
  return {.log_length = j.at("log_length").get<std::vector<double>>(),
          .log_signal = j.at("log_signal"),
          .log_trend = j.at("log_trend"),
          .log_noise = j.at("log_noise")};
}

/// Without the id, which is made from this.
Json body_of(const Model& model) {
  Json out{{"format", kFormat}, {"name", model.name}, {"physics_version", model.physics_version}, {"fixed", model.data.fixed}};
  for (const InputColumn& c : model.data.columns) {
    out["columns"].push_back({{"name", c.name}, {"labels", c.labels}, {"low", c.low}, {"high", c.high}});
  }
  for (const ResponseModel& r : model.responses) {
    const Skill& s = r.skill;
    out["responses"].push_back({{"id", r.id}, {"unit", r.unit}, {"inflation", r.inflation}, {"noise", r.noise}, {"points", s.points}, {"r", s.r}, {"r2", s.r2},
                                {"rms", s.rms}, {"relative", s.relative}, {"coverage", s.coverage}});
    Json& family = out["families"][r.family];
    if (!family.is_null()) continue;
    for (const auto& process : r.processes) family.push_back(hyper_json(process->hyperparameters()));
    out["scatter"][r.family] = {{"slope", r.scatter.slope}, {"centre", r.scatter.centre}};
  }
  if (model.curves) {
    for (const GaussianProcess& p : model.curves->processes) out["curves"].push_back(hyper_json(p.hyperparameters()));
  }
  for (const DataRow& row : model.data.rows) {
    Json means = Json::object();
    for (const auto& [id, mean] : row.mean) {
      if (is_modelled(id) || id.find('@') != std::string::npos) means[id] = {mean.value, mean.seeds};
    }
    out["rows"].push_back({{"source", row.source}, {"x", row.x}, {"mean", std::move(means)}});
  }
  return out;
}

Dataset dataset_from(const Parsed& in) {
  Dataset data;
  data.fixed = in.at("fixed").get<std::map<std::string, std::string>>();
  for (const Parsed& c : in.at("columns")) {
    data.columns.push_back({c.at("name"), c.at("labels").get<std::vector<std::string>>(), c.at("low"), c.at("high")});
  }
  for (const Parsed& r : in.at("responses")) data.unit[r.at("id")] = r.at("unit");
  for (const Parsed& r : in.at("rows")) {
    DataRow row{.source = r.at("source"), .x = r.at("x").get<std::vector<double>>(), .mean = {}};
    if (row.x.size() != data.columns.size()) throw std::out_of_range("a row does not fit the columns");
    for (const auto& [id, mean] : r.at("mean").items()) row.mean[id] = {mean.at(0), mean.at(1), 0.0};
    data.rows.push_back(std::move(row));
  }
  if (data.rows.size() < kFewestRows) throw std::out_of_range("too few rows");
  return data;
}

const Parsed& said_of(const Parsed& in, const std::string& response) {
  for (const Parsed& r : in.at("responses")) {
    if (r.at("id") == response) return r;
  }
  throw std::out_of_range("a response is missing");
}

Scatter scatter_from(const Parsed& in, const std::string& family, std::size_t width) {
  if (!in.contains("scatter") || !in.at("scatter").contains(family)) return {};
  const Parsed& j = in.at("scatter").at(family);
  Scatter scatter{j.at("slope").get<std::vector<double>>(), j.at("centre").get<std::vector<double>>()};
  if (scatter.slope.size() != scatter.centre.size() || (!scatter.slope.empty() && scatter.slope.size() != width)) throw std::out_of_range("scatter does not fit the columns");
  return scatter;
}

Model model_from(const Parsed& in) {
  Model model{.name = in.at("name"), .physics_version = in.at("physics_version"), .data = dataset_from(in), .responses = {}, .curves = {}};
  const auto width = static_cast<std::size_t>(inputs_of(model.data.columns, model.data.rows.front().x).scaled.size());
  const auto checked = [&](const Parsed& j) {
    Hyperparameters h = hyper_of(j);
    if (h.log_length.size() != width) throw std::out_of_range("hyperparameters do not fit the columns");
    return h;
  };
  for (Family& family : families_of(model.data)) {
    family.scatter = scatter_from(in, family.name, width);
    std::vector<Hyperparameters> kept;
    for (const Parsed& j : in.at("families").at(family.name)) kept.push_back(checked(j));
    for (ResponseModel& response : response_models(model.data, family, kept)) {
      const Parsed& said = said_of(in, response.id);
      response.inflation = said.at("inflation");
      response.noise = said.at("noise");
      response.skill = {said.at("points"), said.at("r"), said.at("r2"), said.at("rms"), said.at("relative"), said.at("coverage")};
      model.responses.push_back(std::move(response));
    }
  }
  if (in.contains("curves")) {
    const Parsed& list = in.at("curves");
    model.curves = curve_model(model.data, scatter_from(in, kStrengthFamily, width),
                               [&](Observations o, std::size_t k) { return GaussianProcess(std::move(o), checked(list.at(k))); });
  }
  model.id = in.at("id");
  return model;
}

}  // namespace

std::string id_of(const Model& model) { return sha256_hex(body_of(model).dump()).substr(0, 12); }

std::string to_json(const Model& model) {
  Json out = body_of(model);
  out["id"] = model.id;
  std::string text = "{\n";  // one line a row: readable, and small beside indented arrays
  bool first = true;
  for (const auto& [key, value] : out.items()) {
    text += (first ? "" : ",\n") + Json(key).dump() + ": ";
    first = false;
    if (!value.is_array()) {
      text += value.dump();
      continue;
    }
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i) text += (i ? ",\n " : "\n ") + value[i].dump();
    text += "]";
  }
  return text + "\n}\n";
}

Result<Model> model_from_json(const std::string& text) {
  try {
    const Parsed in = Parsed::parse(text);
    if (in.at("format") != kFormat) return Error{Code::kDataLoss, "not a regolab model (format " + in.at("format").dump() + ") train it again"};
    if (const int version = in.at("physics_version"); version != kPhysicsVersion) {
      return Error{Code::kFailedPrecondition, "the model was trained under physics version " + std::to_string(version) + " (this program has " +
                                                  std::to_string(kPhysicsVersion) + ") train it again"};
    }
    return model_from(in);
  } catch (const std::exception& problem) {  // the library's only way to say that a file is damaged
    return Error{Code::kDataLoss, std::string("the model cannot be read (") + problem.what() + ") train it again"};
  }
}

}  // namespace regolab::surrogate
