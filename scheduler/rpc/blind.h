/// Blind cases over the wire: draws, designs, records and marks. Keeps nothing; runs are the queue's, truths the client's.
#pragma once
#include <string>

#include "regolab/v1/lab.grpc.pb.h"

namespace regolab {

class BlindService final : public v1::Blind::Service {
 public:
  explicit BlindService(std::string database) : database_(std::move(database)) {}

  grpc::Status Draw(grpc::ServerContext*, const v1::BlindDrawRequest*, v1::BlindDrawReply*) override;
  grpc::Status Design(grpc::ServerContext*, const v1::BlindTruth*, v1::BlindDesignReply*) override;
  grpc::Status Observe(grpc::ServerContext*, const v1::BlindObserveRequest*, v1::BlindObserveReply*) override;
  grpc::Status Score(grpc::ServerContext*, grpc::ServerReader<v1::BlindScoreRequest>*, v1::BlindScoreReply*) override;

 private:
  const std::string database_;
};

}  // namespace regolab
