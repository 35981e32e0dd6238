/// Artifacts: beds and checkpoints in pieces, verified on the way in and on the way out.
#pragma once
#include "regolab/v1/work.grpc.pb.h"
#include "scheduler/rpc/desk.h"

namespace regolab {

class ArtifactsService final : public v1::Artifacts::Service {
 public:
  explicit ArtifactsService(Desk& desk) : desk_(desk) {}
  grpc::Status Upload(grpc::ServerContext* context, grpc::ServerReader<v1::Chunk>* reader, v1::UploadReply* reply) override;
  grpc::Status Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                        grpc::ServerWriter<v1::Chunk>* writer) override;

 private:
  Desk& desk_;
};

}  // namespace regolab
