/// Gaps: measurements of a real material, and the bank of our own runs to compare them with. Reads only.
#pragma once
#include <string>

#include "regolab/v1/lab.grpc.pb.h"

namespace regolab {

class GapsService final : public v1::Gaps::Service {
 public:
  explicit GapsService(std::string database) : database_(std::move(database)) {}

  grpc::Status Import(grpc::ServerContext*, const v1::ImportRequest*, v1::ImportReply*) override;
  grpc::Status Bank(grpc::ServerContext*, const v1::BankRequest*, v1::BankReply*) override;
  grpc::Status Emulate(grpc::ServerContext*, const v1::EmulateRequest*, v1::EmulateReply*) override;
  grpc::Status Diagnose(grpc::ServerContext*, const v1::DiagnoseRequest*, grpc::ServerWriter<v1::DiagnoseEvent>*) override;

 private:
  const std::string database_;
};

}  // namespace regolab
