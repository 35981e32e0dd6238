#include "scheduler/rpc/surrogates.h"

#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/surrogate_convert.h"
#include "scheduler/rpc/surrogate_source.h"
#include "scheduler/surrogate/material.h"

namespace regolab {
namespace {

constexpr int kMostMaterials = 100000;  // in one call

Error no_model() {
  return {Code::kFailedPrecondition, "no model here (this build ships none, and none was trained) train one: regolab train EXPERIMENT"};
}

v1::EstimatedCurve to_curve(double sigma3, const std::vector<surrogate::Estimate>& values) {
  v1::EstimatedCurve out;
  out.set_sigma3_pa(sigma3);
  for (std::size_t k = 0; k < values.size(); ++k) {
    out.add_axial_strain(0.01 * static_cast<double>(k));
    *out.add_sigma1() = to_proto(values[k]);
  }
  return out;
}

Error outside_stresses(double sigma3) {
  return invalid("sigma3 = " + std::to_string(sigma3 / 1000) + " kPa is outside what the model was trained on (see `regolab models`) ask within");
}

Result<v1::Prediction> prediction(const surrogate::Model& model, const v1::PredictRequest& request, const v1::Material& asked) {
  const auto material = surrogate::read_material(model, {asked.set().begin(), asked.set().end()});
  if (!material.ok()) return material.error();
  v1::Prediction out;
  for (const auto& estimate : model.predict(material->x)) *out.add_estimates() = to_proto(estimate);
  for (const double sigma3 : request.sigma3_pa()) {
    const auto estimate = model.sigma1_at(material->x, sigma3);
    if (!estimate) return outside_stresses(sigma3);
    *out.add_estimates() = to_proto(*estimate);
  }
  for (const double sigma3 : request.curves_at_pa()) {
    const auto values = model.curve_at(material->x, sigma3);
    if (values.empty()) return outside_stresses(sigma3);
    *out.add_curves() = to_curve(sigma3, values);
  }
  for (const std::string& text : material->outside) out.add_outside(text);
  for (const std::string& text : material->assumed) out.add_assumed(text);
  return out;
}

}  // namespace

Result<SurrogatesService::Held> SurrogatesService::load(const std::string& id) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return reader.error();
  auto record = reader->model(id);
  if (!record.ok()) return record.error();
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = loaded_.find(record->id); found != loaded_.end()) return found->second;
  }
  auto model = surrogate::model_from_json(record->file);
  if (!model.ok()) return Error{model.error().code, "model " + record->id + ": " + model.error().text};
  auto held = std::make_shared<const surrogate::Model>(std::move(*model));
  const std::lock_guard lock(mutex_);
  return loaded_[record->id] = std::move(held);
}

Result<SurrogatesService::Held> SurrogatesService::model(const std::string& id) {
  const surrogate::Model* own = surrogate::shipped_model();
  const auto shipped = [&] { return Held(Held{}, own); };  // lives as long as the program
  if (!id.empty() && own && own->id.starts_with(id)) return shipped();
  if (!id.empty()) return load(id);
  auto reader = Reader::open(database_);
  if (!reader.ok()) return reader.error();
  const auto models = reader->models();
  if (!models.ok()) return models.error();
  if (!models->empty()) return load(models->front().id);
  if (!own) return no_model();
  return shipped();
}

Result<void> SurrogatesService::keep(const surrogate::Model& model) {
  return desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
    if (auto begun = turn.begin(); !begun.ok()) return begun;
    return turn.store.add_model({model.id, model.name, turn.unix_ms, surrogate::to_json(model)});
  });
}

grpc::Status SurrogatesService::Train(grpc::ServerContext* context, const v1::TrainRequest* request, grpc::ServerWriter<v1::TrainEvent>* writer) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  std::vector<surrogate::Source> sources;
  for (const std::string& label : request->experiments()) {
    auto source = surrogate_source(*reader, label);
    if (!source.ok()) return to_grpc(source.error());
    sources.push_back(std::move(*source));
  }
  auto data = surrogate::dataset_of(sources);
  if (!data.ok()) return to_grpc(data.error());
  const std::string name = request->name().empty() ? request->experiments(0) : request->name();
  const auto model = surrogate::train(name, std::move(*data), [&](const std::string& response, int done, int of) {
    v1::TrainEvent event;
    event.set_response(response);
    event.set_done(static_cast<std::uint32_t>(done));
    event.set_of(static_cast<std::uint32_t>(of));
    return writer->Write(event) && !context->IsCancelled();
  });
  if (!model.ok()) return to_grpc(model.error());
  if (auto kept = keep(*model); !kept.ok()) return to_grpc(kept.error());
  v1::TrainEvent last;
  *last.mutable_model() = to_proto(*model, 0);
  if (request->want_file()) last.set_file(surrogate::to_json(*model));
  writer->Write(last);
  return grpc::Status::OK;
}

grpc::Status SurrogatesService::Predict(grpc::ServerContext*, const v1::PredictRequest* request, v1::PredictReply* reply) {
  if (request->materials_size() > kMostMaterials) return to_grpc(invalid("too many materials in one call (at most 100000) split it"));
  const auto held = model(request->model());
  if (!held.ok()) return to_grpc(held.error());
  reply->set_model((*held)->id);
  reply->set_model_name((*held)->name);
  for (int k = 0; k < request->materials_size(); ++k) {
    auto one = prediction(**held, *request, request->materials(k));
    if (!one.ok()) {
      const std::string which = request->materials_size() > 1 ? "material " + std::to_string(k + 1) + ": " : "";
      return to_grpc({one.error().code, which + one.error().text});
    }
    *reply->add_predictions() = std::move(*one);
  }
  return grpc::Status::OK;
}

grpc::Status SurrogatesService::ListModels(grpc::ServerContext*, const v1::ListModelsRequest*, v1::ListModelsReply* reply) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const auto models = reader->models();
  if (!models.ok()) return to_grpc(models.error());
  for (const ModelRecord& record : *models) {
    const auto held = load(record.id);
    if (held.ok()) {
      *reply->add_models() = to_proto(**held, record.created_ms);
    } else {  // of another version: still listed, without its skill
      v1::ModelSummary* summary = reply->add_models();
      summary->set_id(record.id);
      summary->set_name(record.name + " (" + held.error().text + ")");
      summary->set_created_unix_ms(record.created_ms);
    }
  }
  if (const surrogate::Model* own = surrogate::shipped_model()) *reply->add_models() = to_proto(*own, 0);
  return grpc::Status::OK;
}

}  // namespace regolab
