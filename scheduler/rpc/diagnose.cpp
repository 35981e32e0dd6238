#include "digest/sha256.h"
#include "scheduler/gap/diagnosis.h"
#include "scheduler/gap/fit.h"
#include "scheduler/gap/held_out.h"
#include "scheduler/gap/kernels.h"
#include "scheduler/gap/observation_csv.h"
#include "scheduler/gap/reach.h"
#include "scheduler/rpc/analysis_convert.h"
#include "scheduler/rpc/confirmation.h"
#include "scheduler/rpc/diagnosis_book.h"
#include "scheduler/rpc/gap_convert.h"
#include "scheduler/rpc/gaps.h"
#include "scheduler/rpc/grpc_status.h"

namespace regolab {
namespace {

constexpr std::size_t kShownDigest = 12;

/// What every diagnosis says of where it comes from.
void add_provenance(const DiagnosisRecord& record, std::uint64_t seed, v1::Diagnosis& out) {
  out.set_id(record.id);
  out.set_case_name(record.case_name);
  out.set_bank(record.bank.substr(0, kShownDigest)), out.set_kernels(record.kernels.substr(0, kShownDigest)), out.set_method(record.method.substr(0, kShownDigest));
  out.set_seed(seed), out.set_physics_version(kPhysicsVersion);
}

void add_held_out(const std::vector<double>& held_out, v1::Diagnosis& out) {
  for (const double sigma3 : held_out) out.add_held_out(gap::held_out_text(std::span(&sigma3, 1))), out.add_held_out_pa(sigma3);
}

void add_fits(const gap::Emulator& emulator, const gap::ObservationSet& set, const gap::Diagnosis& found, const std::vector<double>& held_out, v1::Diagnosis& out) {
  for (const gap::FeatureFit& fit : gap::fits_of(emulator, gap::compare(emulator, set), found)) {
    v1::FittedFeature& feature = *out.add_fits();
    feature = to_proto(fit);
    feature.set_held_out(std::ranges::find(held_out, fit.measured.group.sigma3) != held_out.end());
  }
  if (const gap::Weighed* repaired = gap::repaired_by(found)) out.set_repaired(repaired->model);
  for (const gap::Axis& axis : emulator.space().axes) out.add_axes(axis.name);
}

gap::DiagnosisOptions options_of(const v1::DiagnoseRequest& request) {
  gap::DiagnosisOptions options;
  if (request.seed() != 0) options.smc.seed = request.seed();
  return options;
}

/// What is stated of the material and lies outside the bank, told where it stands in the file.
std::vector<Diagnostic> refused_by(const gap::Reach& reach, const gap::ObservationSet& set, const v1::ImportRequest& file) {
  const bool mapped = !file.map_name().empty();  // conditions then stand in the map
  Report report(file.file_name(), mapped ? "" : file.content());
  for (const gap::OutOfReach& one : reach.refused) {
    const auto place = set.places.find(one.key);
    report.add(place == set.places.end() || mapped ? Place{} : place->second, one.text);
  }
  return report.take();
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

Result<std::optional<GapsService::Question>> GapsService::read(const v1::DiagnoseRequest& request, v1::DiagnoseEvent& event) {
  const auto set = read_measurements_of(request.measurements());
  for (const Diagnostic& diagnostic : set.diagnostics) *event.add_diagnostics() = to_proto(diagnostic);
  if (!set.ok()) return std::optional<Question>();  // before the bank is read, which takes seconds
  auto bank = banks_.of(request);
  if (!bank.ok()) return bank.error();
  for (const Diagnostic& diagnostic : bank->diagnostics) *event.add_diagnostics() = to_proto(diagnostic);
  if (!bank->diagnostics.empty()) return std::optional<Question>();
  const gap::Reach reach = gap::reach_of(*bank->emulator, *set.value);
  for (const Diagnostic& diagnostic : refused_by(reach, *set.value, request.measurements())) *event.add_diagnostics() = to_proto(diagnostic);
  if (!reach.refused.empty()) return std::optional<Question>();
  Question out{.set = *set.value, .fitted = *set.value, .held_out = {}, .bank = std::move(*bank)};
  if (!request.hold_out()) return std::optional(std::move(out));
  const auto held = gap::held_out_sigma3(gap::compare(*out.bank.emulator, out.set).measured);
  if (!held.ok()) return held.error();
  out.held_out = *held;
  out.fitted = gap::without(out.set, out.held_out);
  for (const gap::Feature& left : gap::compare(*out.bank.emulator, out.fitted).measured) {
    if (std::ranges::find(out.held_out, left.group.sigma3) == out.held_out.end()) continue;
    return Error{Code::kFailedPrecondition, left.id + " cannot be held out (it follows from other numbers of the file) give sigma1 at each sigma3 itself"};
  }
  return std::optional(std::move(out));
}

grpc::Status GapsService::Diagnose(grpc::ServerContext* context, const v1::DiagnoseRequest* request, grpc::ServerWriter<v1::DiagnoseEvent>* writer) {
  v1::DiagnoseEvent event;
  const auto question = read(*request, event);
  if (!question.ok()) return to_grpc(question.error());
  if (!*question) {
    writer->Write(event);
    return grpc::Status::OK;
  }
  const Question& q = **question;
  auto book = DiagnosisBook::open(desk_, database_, diagnosis_record(*request, q.bank, q.set.name, gap::held_out_text(q.held_out)));
  if (!book.ok()) return to_grpc(book.error());
  event.set_stored((*book)->finished());
  if (!event.stored()) {
    const gap::StepMemory memory = (*book)->memory();
    gap::DiagnosisOptions options = options_of(*request);
    options.memory = &memory;
    const auto found = gap::diagnose(*q.bank.emulator, q.fitted, options, [&](const std::string& what, int done, int of) {
      v1::DiagnoseEvent step;
      step.set_what(what), step.set_done(static_cast<std::uint32_t>(done)), step.set_of(static_cast<std::uint32_t>(of));
      return writer->Write(step) && !context->IsCancelled();
    });
    if (!found.ok()) return to_grpc(found.error());
    v1::Diagnosis out = to_proto(*found);
    const gap::Reach reach = gap::reach_of(*q.bank.emulator, q.set);
    for (const gap::Unused& one : reach.left_out) out.add_warnings(one.id + " takes no part: " + one.why);
    for (const std::string& warning : reach.warnings) out.add_warnings(warning);
    add_provenance((*book)->record(), options.smc.seed, out);
    add_held_out(q.held_out, out);
    add_fits(*q.bank.emulator, q.set, *found, q.held_out, out);
    for (const auto& [name, value] : q.bank.constants) (*out.mutable_constants_si())[name] = value;
    if (request->hold_out()) out.set_first_seed(first_seed_of((*book)->record().id, q.bank.seeds));
    if (auto kept = (*book)->end(out); !kept.ok()) return to_grpc(kept.error());
  }
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const auto record = reader->diagnosis((*book)->record().id);
  if (!record.ok()) return to_grpc(record.error());
  auto stored = stored_diagnosis(*reader, *record);
  if (!stored.ok()) return to_grpc(stored.error());
  *event.mutable_diagnosis() = std::move(*stored);
  writer->Write(event);
  return grpc::Status::OK;
}

grpc::Status GapsService::Locate(grpc::ServerContext*, const v1::DiagnoseRequest* request, grpc::ServerWriter<v1::DiagnoseEvent>* writer) {
  v1::DiagnoseEvent event;
  const auto question = read(*request, event);
  if (!question.ok()) return to_grpc(question.error());
  if (!*question) {
    writer->Write(event);
    return grpc::Status::OK;
  }
  const Question& q = **question;
  auto book = DiagnosisBook::open(desk_, database_, diagnosis_record(*request, q.bank, q.set.name, gap::held_out_text(q.held_out)));
  if (!book.ok()) return to_grpc(book.error());
  const gap::StepMemory memory = (*book)->memory();
  gap::DiagnosisOptions options = options_of(*request);
  options.memory = &memory;
  v1::DiagnoseEvent step;
  step.set_what("where"), step.set_of(1);
  writer->Write(step);
  const auto where = gap::locate(*q.bank.emulator, q.fitted, options);
  if (!where.ok()) return to_grpc(where.error());
  v1::Diagnosis& out = *event.mutable_diagnosis();
  add_where(*where, out);
  add_provenance((*book)->record(), options.smc.seed, out);
  out.set_features(static_cast<std::uint32_t>(gap::compare(*q.bank.emulator, q.fitted).size()));
  writer->Write(event);
  return grpc::Status::OK;
}

}  // namespace regolab
