#include "client/surrogate_json.h"

#include <nlohmann/json.hpp>

namespace regolab::client {
namespace {

Json words(const google::protobuf::RepeatedPtrField<std::string>& list) {
  Json out = Json::array();
  for (const auto& word : list) out.push_back(word);
  return out;
}

Json json_of(const pb::ModelInput& input) {
  Json out{{"name", input.name()}, {"unit", input.unit()}};
  if (!input.labels().empty()) out["choices"] = words(input.labels());
  else out["low"] = input.low(), out["high"] = input.high();
  return out;
}

Json json_of(const pb::ModelSkill& s) {
  return {{"response", s.response()}, {"unit", s.unit()},         {"points", s.points()},     {"r", s.r()},
          {"r2", s.r2()},             {"of_logarithm", s.logarithm()}, {"rms_error", s.rms()}, {"mean_relative_error", s.relative()},
          {"coverage_of_90_percent_bands", s.coverage()}};
}

Json json_of(const google::protobuf::Map<std::string, std::string>& map) {
  const std::map<std::string, std::string> sorted(map.begin(), map.end());
  return sorted;
}

}  // namespace

Json json_of(const pb::ModelSummary& model) {
  Json out{{"id", model.id()}, {"name", model.name()}, {"points", model.rows()}, {"came_with_the_program", model.created_unix_ms() == 0}};
  out["inputs"] = Json::array(), out["left_one_out"] = Json::array();
  for (const auto& input : model.inputs()) out["inputs"].push_back(json_of(input));
  out["fixed"] = json_of(model.fixed());
  for (const auto& skill : model.skills()) out["left_one_out"].push_back(json_of(skill));
  out["stress_strain_curves"] = model.curves();
  return out;
}

Json json_of(const pb::Estimate& e) {
  return {{"response", e.response()}, {"unit", e.unit()}, {"value", e.value()}, {"low_90", e.low()}, {"high_90", e.high()},
          {"mean_low_90", e.mean_low()}, {"mean_high_90", e.mean_high()}};
}

void add_predictions(const pb::PredictReply& reply, Json& document) {
  document["model"] = reply.model();
  document["model_name"] = reply.model_name();
  document["predictions"] = Json::array();
  for (const auto& p : reply.predictions()) {
    Json one{{"estimates", Json::array()}, {"curves", Json::array()}, {"outside_the_data", words(p.outside())}, {"assumed", words(p.assumed())}};
    for (const auto& e : p.estimates()) one["estimates"].push_back(json_of(e));
    for (const auto& c : p.curves()) {
      Json curve{{"sigma3_kPa", c.sigma3_pa() / 1000}, {"axial_strain", Json::array()}, {"sigma1", Json::array()}};
      for (int k = 0; k < c.sigma1_size(); ++k) {
        curve["axial_strain"].push_back(c.axial_strain(k));
        curve["sigma1"].push_back(json_of(c.sigma1(k)));
      }
      one["curves"].push_back(std::move(curve));
    }
    document["predictions"].push_back(std::move(one));
  }
}

void add_inversion(const pb::InvertReply& reply, Json& document) {
  document["model"] = reply.model();
  document["model_name"] = reply.model_name();
  document["targets"] = Json::array(), document["candidates"] = Json::array(), document["left_open"] = Json::array();
  for (const auto& t : reply.targets()) {
    document["targets"].push_back({{"response", t.response()}, {"unit", t.unit()}, {"value", t.value()}, {"tolerance", t.tolerance()}});
  }
  for (const auto& c : reply.candidates()) {
    Json one{{"set", json_of(c.set())}, {"probability", c.probability()}, {"largest_miss_in_tolerances", c.miss()}, {"estimates", Json::array()}};
    for (const auto& e : c.estimates()) one["estimates"].push_back(json_of(e));
    document["candidates"].push_back(std::move(one));
  }
  for (const auto& f : reply.freedom()) {
    Json one{{"input", f.input()}, {"unit", f.unit()}};
    if (f.labels().empty()) one["low"] = f.low(), one["high"] = f.high(), one["box_low"] = f.box_low(), one["box_high"] = f.box_high();
    else one["choices"] = words(f.labels());
    document["left_open"].push_back(std::move(one));
  }
  document["materials_tried"] = reply.tried();
  document["materials_that_may_fit"] = reply.fitting();
  document["notes"] = words(reply.notes());
}

}  // namespace regolab::client
