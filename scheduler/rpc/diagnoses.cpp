/// Diagnoses in the store: listed, and one with its measurements.
#include "scheduler/rpc/diagnosis_book.h"
#include "scheduler/rpc/gap_convert.h"
#include "scheduler/rpc/gaps.h"
#include "scheduler/rpc/grpc_status.h"
#include "vocab/units.h"

namespace regolab {
namespace {

v1::StoredDiagnosis head_of(const DiagnosisRecord& record) {
  v1::StoredDiagnosis out;
  out.set_id(record.id), out.set_case_name(record.case_name), out.set_held_out(record.held_out);
  out.set_created_unix_ms(record.created_ms), out.set_ended_unix_ms(record.ended_ms.value_or(0));
  return out;
}

Result<void> add_steps(Reader& reader, const std::string& id, v1::StoredDiagnosis& out) {
  const auto steps = reader.diagnosis_steps(id);
  if (!steps.ok()) return steps.error();
  for (const DiagnosisStep& step : *steps) {
    auto& one = *out.add_steps();
    one.set_name(step.name), one.set_done_unix_ms(step.done_ms), one.set_bytes(step.result.size());
  }
  return {};
}

Result<void> add_result(Reader& reader, const DiagnosisRecord& record, v1::StoredDiagnosis& out) {
  if (!record.ended_ms) return {};
  auto diagnosis = stored_diagnosis(reader, record);
  if (!diagnosis.ok()) return diagnosis.error();
  *out.mutable_diagnosis() = std::move(*diagnosis);
  return {};
}

/// The file as it was handed in, read again.
void add_measurements(const std::string& bytes, v1::StoredDiagnosis& out) {
  v1::ImportRequest request;
  if (!request.ParseFromString(bytes)) return;
  const auto set = read_measurements_of(request);
  if (!set.ok()) return;
  *out.mutable_measured() = to_proto(*set.value);
  for (const gap::MeasuredCurve& c : set.value->curves) {
    v1::Curve& curve = *out.add_curves();
    curve.set_id(c.id), curve.set_test(c.test);
    curve.set_x_name(c.x_name), curve.set_x_unit_si(c.x_unit), curve.set_y_name(c.y_name), curve.set_y_unit_si(c.y_unit);
    for (const double x : c.x) curve.add_x_si(x);
    for (const double y : c.y) curve.add_y_si(y);
  }
}

/// The newest finished one that saw the whole of this file.
Result<std::string> newest_of(Reader& reader, const v1::ImportRequest& measurements) {
  const auto all = reader.diagnoses();
  if (!all.ok()) return all.error();
  const std::string wanted = observations_digest(measurements);
  for (const DiagnosisRecord& record : *all) {
    if (record.observations == wanted && record.held_out.empty() && record.ended_ms) return record.id;
  }
  return Error{Code::kFailedPrecondition, measurements.file_name() + " was not diagnosed here (or has changed since) diagnose it first: regolab gap diagnose " +
                                              measurements.file_name()};
}

}  // namespace

grpc::Status GapsService::ListDiagnoses(grpc::ServerContext*, const v1::ListDiagnosesRequest*, v1::ListDiagnosesReply* reply) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const auto all = reader->diagnoses();
  if (!all.ok()) return to_grpc(all.error());
  for (const DiagnosisRecord& record : *all) {
    v1::StoredDiagnosis& one = *reply->add_diagnoses();
    one = head_of(record);
    if (auto added = add_result(*reader, record, one); !added.ok()) return to_grpc(added.error());
    if (record.ended_ms) continue;
    if (auto added = add_steps(*reader, record.id, one); !added.ok()) return to_grpc(added.error());
  }
  return grpc::Status::OK;
}

grpc::Status GapsService::GetDiagnosis(grpc::ServerContext*, const v1::GetDiagnosisRequest* request, v1::StoredDiagnosis* reply) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  std::string id = request->id();
  if (id.empty()) {
    const auto newest = newest_of(*reader, request->measurements());
    if (!newest.ok()) return to_grpc(newest.error());
    id = *newest;
  }
  const auto record = reader->diagnosis(id);
  if (!record.ok()) return to_grpc(record.error());
  *reply = head_of(*record);
  if (auto added = add_steps(*reader, record->id, *reply); !added.ok()) return to_grpc(added.error());
  if (auto added = add_result(*reader, *record, *reply); !added.ok()) return to_grpc(added.error());
  add_measurements(record->measurements, *reply);
  return grpc::Status::OK;
}

}  // namespace regolab
