/// Experiments: submit, look, cancel, retry. Watch is a stream of its own (watch.h).
#pragma once
#include "regolab/v1/lab.grpc.pb.h"
#include "scheduler/rpc/desk.h"
#include "scheduler/rpc/submission.h"
#include "scheduler/rpc/watch.h"

namespace regolab {

class ExperimentsService final : public v1::Experiments::WithCallbackMethod_Watch<v1::Experiments::Service> {
 public:
  ExperimentsService(Desk& desk, WatchHub& hub) : desk_(desk), hub_(hub) {}

  grpc::Status Validate(grpc::ServerContext*, const v1::SubmitRequest*, v1::SubmitReply*) override;
  grpc::Status Submit(grpc::ServerContext*, const v1::SubmitRequest*, v1::SubmitReply*) override;
  grpc::Status List(grpc::ServerContext*, const v1::ListRequest*, v1::ListReply*) override;
  grpc::Status Get(grpc::ServerContext*, const v1::GetRequest*, v1::ExperimentStatus*) override;
  grpc::Status Cancel(grpc::ServerContext*, const v1::CancelRequest*, v1::ExperimentStatus*) override;
  grpc::Status Retry(grpc::ServerContext*, const v1::RetryRequest*, v1::ExperimentStatus*) override;
  grpc::ServerWriteReactor<v1::WatchEvent>* Watch(grpc::CallbackServerContext*, const v1::WatchRequest*) override;

 private:
  Result<void> take_in(Submission& submission, Desk::Turn& turn, v1::SubmitReply& reply);
  Desk& desk_;
  WatchHub& hub_;
};

/// kNotFound with a remedy.
Error no_such_experiment(const std::string& label);

}  // namespace regolab
