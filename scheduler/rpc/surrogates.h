/// Surrogates: trained on experiments in the store, kept there, asked from memory. Work is done on the caller's thread; only the new
/// model's row goes through the desk.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "regolab/v1/lab.grpc.pb.h"
#include "scheduler/rpc/desk.h"
#include "scheduler/surrogate/model.h"

namespace regolab {

class SurrogatesService final : public v1::Surrogates::Service {
 public:
  SurrogatesService(Desk& desk, std::string database) : desk_(desk), database_(std::move(database)) {}

  grpc::Status Train(grpc::ServerContext*, const v1::TrainRequest*, grpc::ServerWriter<v1::TrainEvent>*) override;
  grpc::Status Predict(grpc::ServerContext*, const v1::PredictRequest*, v1::PredictReply*) override;
  grpc::Status ListModels(grpc::ServerContext*, const v1::ListModelsRequest*, v1::ListModelsReply*) override;
  grpc::Status Invert(grpc::ServerContext*, const v1::InvertRequest*, v1::InvertReply*) override;

 private:
  using Held = std::shared_ptr<const surrogate::Model>;
  /// By id or its start; empty: the newest in the store, else the program's own.
  Result<Held> model(const std::string& id);
  Result<Held> load(const std::string& id);
  Result<void> keep(const surrogate::Model& model);

  Desk& desk_;
  const std::string database_;
  std::mutex mutex_;
  std::map<std::string, Held> loaded_;  ///< guarded by mutex_; a model never changes
};

}  // namespace regolab
