#include "scheduler/rpc/gaps.h"

#include "scheduler/gap/observation_csv.h"
#include "scheduler/rpc/analysis_convert.h"
#include "scheduler/rpc/bank_source.h"
#include "scheduler/rpc/gap_convert.h"
#include "scheduler/rpc/grpc_status.h"

namespace regolab {

Read<gap::ObservationSet> read_measurements_of(const v1::ImportRequest& request) {
  const auto missing = request.assume_errors() ? gap::MissingErrors::kAssume : gap::MissingErrors::kRefuse;
  if (request.map_name().empty()) return gap::read_observations(request.file_name(), request.content(), missing);
  return gap::read_measurements({.map_name = request.map_name(), .map_text = request.map(), .csv_name = request.file_name(), .csv_text = request.content()}, missing);
}

grpc::Status GapsService::Import(grpc::ServerContext*, const v1::ImportRequest* request, v1::ImportReply* reply) {
  const auto set = read_measurements_of(*request);
  for (const Diagnostic& diagnostic : set.diagnostics) *reply->add_diagnostics() = to_proto(diagnostic);
  if (!set.ok()) return grpc::Status::OK;
  *reply = to_proto(*set.value);
  if (request->want_file()) reply->set_file(gap::observations_yaml(*set.value));
  return grpc::Status::OK;
}

grpc::Status GapsService::Bank(grpc::ServerContext* context, const v1::BankRequest* request, v1::BankReply* reply) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  std::vector<gap::BankSource> sources;
  for (const std::string& label : request->experiments()) {
    auto more = bank_sources(*reader, label);
    if (!more.ok()) return to_grpc(more.error());
    for (gap::BankSource& source : *more) sources.push_back(std::move(source));
    if (context->IsCancelled()) return grpc::Status::CANCELLED;
  }
  const gap::Bank bank = gap::bank_of(sources);
  if (bank.rows.empty()) {
    return to_grpc({Code::kFailedPrecondition, "no runs with numbers (a bank has a row for each point and seed that was measured) name an experiment that has run"});
  }
  reply->set_csv(gap::bank_csv(bank));
  reply->set_rows(static_cast<std::uint32_t>(bank.rows.size()));
  reply->set_without_numbers(static_cast<std::uint32_t>(sources.size() - bank.rows.size()));
  for (const auto& input : bank.inputs) reply->add_inputs(input.name);
  for (const std::string& id : bank.features) reply->add_features(id);
  return grpc::Status::OK;
}

}  // namespace regolab
