#include "digest/sha256.h"
#include "scheduler/gap/bank_in_use.h"
#include "scheduler/gap/diagnosis.h"
#include "scheduler/gap/kernels.h"
#include "scheduler/gap/observation_csv.h"
#include "scheduler/rpc/analysis_convert.h"
#include "scheduler/rpc/gap_convert.h"
#include "scheduler/rpc/gaps.h"
#include "scheduler/rpc/grpc_status.h"

namespace regolab {
namespace {

/// SHA-256 of the bank's text, 12 digits.
std::string id_of(const v1::DiagnoseRequest& request) {
  return sha256_hex(request.bank_csv().empty() ? std::string(gap::shipped_bank()) : request.bank_csv()).substr(0, 12);
}

}  // namespace

grpc::Status GapsService::Emulate(grpc::ServerContext*, const v1::EmulateRequest* request, v1::EmulateReply* reply) {
  const auto bank = gap::read_bank(request->file_name(), request->bank_csv());
  for (const Diagnostic& diagnostic : bank.diagnostics) *reply->add_diagnostics() = to_proto(diagnostic);
  if (!bank.ok()) return grpc::Status::OK;
  const auto emulator = gap::Emulator::from(*bank.value);
  if (!emulator.ok()) return to_grpc(emulator.error());
  reply->set_kernels_json(gap::kernels_json(emulator->kernels()));
  for (const gap::Cause& cause : emulator->causes()) reply->add_effects(std::string(cause.effect->name));
  return grpc::Status::OK;
}

grpc::Status GapsService::Diagnose(grpc::ServerContext* context, const v1::DiagnoseRequest* request, grpc::ServerWriter<v1::DiagnoseEvent>* writer) {
  v1::DiagnoseEvent event;
  const auto set = read_measurements_of(request->measurements());
  for (const Diagnostic& diagnostic : set.diagnostics) *event.add_diagnostics() = to_proto(diagnostic);
  const gap::BankInUse bank = gap::bank_in_use(request->bank_name(), request->bank_csv(), request->kernels_json());
  for (const Diagnostic& diagnostic : bank.diagnostics) *event.add_diagnostics() = to_proto(diagnostic);
  if (!set.ok() || !bank.diagnostics.empty()) {
    writer->Write(event);
    return grpc::Status::OK;
  }
  if (!bank.emulator().ok()) return to_grpc(bank.emulator().error());
  gap::DiagnosisOptions options;
  if (request->seed() != 0) options.smc.seed = request->seed();
  const auto found = gap::diagnose(*bank.emulator(), *set.value, options, [&](const std::string& what, int done, int of) {
    v1::DiagnoseEvent step;
    step.set_what(what), step.set_done(static_cast<std::uint32_t>(done)), step.set_of(static_cast<std::uint32_t>(of));
    return writer->Write(step) && !context->IsCancelled();
  });
  if (!found.ok()) return to_grpc(found.error());
  *event.mutable_diagnosis() = to_proto(*found);
  event.mutable_diagnosis()->set_case_name(set.value->name);
  event.mutable_diagnosis()->set_bank(id_of(*request));
  event.mutable_diagnosis()->set_seed(options.smc.seed);
  event.mutable_diagnosis()->set_physics_version(kPhysicsVersion);
  writer->Write(event);
  return grpc::Status::OK;
}

}  // namespace regolab
