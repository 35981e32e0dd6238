/// WorkerPool: one long poll per worker. Handlers translate and check; the desk decides.
#pragma once
#include "regolab/v1/work.grpc.pb.h"
#include "scheduler/rpc/desk.h"

namespace regolab {

class WorkerPoolService final : public v1::WorkerPool::CallbackService {
 public:
  explicit WorkerPoolService(Desk& desk) : desk_(desk) {}
  grpc::ServerUnaryReactor* Sync(grpc::CallbackServerContext* context, const v1::SyncRequest* request,
                                 v1::SyncReply* reply) override;

 private:
  Desk& desk_;
};

}  // namespace regolab
