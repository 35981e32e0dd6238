/// Gaps: measurements of a real material, the bank of our own runs to compare them with, and what is found. Work is done on the caller's
/// thread; only rows of diagnoses go through the desk.
#pragma once
#include <string>

#include "regolab/v1/lab.grpc.pb.h"
#include "scheduler/gap/observation.h"
#include "scheduler/rpc/bank_cache.h"
#include "scheduler/rpc/desk.h"

namespace regolab {

class GapsService final : public v1::Gaps::Service {
 public:
  GapsService(Desk& desk, std::string database) : desk_(desk), database_(std::move(database)) {}

  grpc::Status Import(grpc::ServerContext*, const v1::ImportRequest*, v1::ImportReply*) override;
  grpc::Status Bank(grpc::ServerContext*, const v1::BankRequest*, v1::BankReply*) override;
  grpc::Status Emulate(grpc::ServerContext*, const v1::EmulateRequest*, v1::EmulateReply*) override;
  grpc::Status Diagnose(grpc::ServerContext*, const v1::DiagnoseRequest*, grpc::ServerWriter<v1::DiagnoseEvent>*) override;
  grpc::Status Locate(grpc::ServerContext*, const v1::DiagnoseRequest*, grpc::ServerWriter<v1::DiagnoseEvent>*) override;
  grpc::Status ListDiagnoses(grpc::ServerContext*, const v1::ListDiagnosesRequest*, v1::ListDiagnosesReply*) override;
  grpc::Status GetDiagnosis(grpc::ServerContext*, const v1::GetDiagnosisRequest*, v1::StoredDiagnosis*) override;
  grpc::Status PlanConfirmation(grpc::ServerContext*, const v1::PlanRequest*, v1::PlanReply*) override;
  grpc::Status MeasureShrinkage(grpc::ServerContext*, const v1::ShrinkageRequest*, v1::StoredDiagnosis*) override;

 private:
  /// A request read: the set, what of it is fitted, and the bank. `event` gets diagnostics, which mean that the rest is empty.
  struct Question {
    gap::ObservationSet set, fitted;
    std::vector<double> held_out;  ///< [Pa]
    HeldBank bank;
  };
  Result<std::optional<Question>> read(const v1::DiagnoseRequest& request, v1::DiagnoseEvent& event);

  Desk& desk_;
  const std::string database_;
  BankCache banks_;
};

}  // namespace regolab
