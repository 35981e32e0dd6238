#include "scheduler/rpc/diagnosis_book.h"

#include <google/protobuf/util/json_util.h>

#include "digest/sha256.h"
#include "scheduler/gap/method.h"

namespace regolab {
namespace {

std::string digest_of(std::initializer_list<std::string_view> parts) {
  Sha256 sum;
  for (const std::string_view part : parts) sum.add(std::to_string(part.size()) + ":"), sum.add(part);
  return sum.hex();
}

/// Everything beside the files that an answer depends on.
std::string options_json(const v1::DiagnoseRequest& request) {
  return "{\"seed\":" + std::to_string(request.seed() == 0 ? 1 : request.seed()) + ",\"physics_version\":" + std::to_string(kPhysicsVersion) + "}";
}

template <class Message>
Result<Message> from_json(const std::string& json, const char* what) {
  Message message;
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = true;  // of another version
  if (!google::protobuf::util::JsonStringToMessage(json, &message, options).ok()) {
    return Error{Code::kDataLoss, std::string("the stored ") + what + " cannot be read (damaged, or of another version) diagnose again with another --seed"};
  }
  return message;
}

}  // namespace

std::string json_of(const google::protobuf::Message& message) {
  std::string json;
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  (void)google::protobuf::util::MessageToJsonString(message, &json, options);
  return json;
}

std::string observations_digest(const v1::ImportRequest& m) {
  return digest_of({m.content(), m.map_name().empty() ? "" : "map", m.map(), m.assume_errors() ? "errors assumed" : ""});
}

DiagnosisRecord diagnosis_record(const v1::DiagnoseRequest& request, const HeldBank& bank, const std::string& case_name, const std::string& held_out) {
  DiagnosisRecord r{.case_name = case_name, .observations = observations_digest(request.measurements()), .bank = bank.bank, .kernels = bank.kernels,
                    .method = std::string(gap::method_digest()), .options = options_json(request), .held_out = held_out,
                    .measurements = request.measurements().SerializeAsString(), .result = {}, .shrinkage = {}};
  r.id = digest_of({r.observations, r.bank, r.kernels, r.method, r.options, r.held_out});
  return r;
}

Result<void> DiagnosisBook::write(const std::function<Result<void>(Desk::Turn&)>& rows) {
  return desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
    if (auto begun = turn.begin(); !begun.ok()) return begun;
    return rows(turn);
  });
}

Result<std::unique_ptr<DiagnosisBook>> DiagnosisBook::open(Desk& desk, const std::string& database, const DiagnosisRecord& record) {
  std::unique_ptr<DiagnosisBook> book(new DiagnosisBook(desk, record));
  auto reader = Reader::open(database);
  if (!reader.ok()) return reader.error();
  auto known = reader->diagnosis(record.id);
  if (!known.ok() && known.error().code != Code::kNotFound) return known.error();
  if (known.ok()) {
    book->record_ = std::move(*known);
    if (book->finished()) return book;
    auto steps = reader->diagnosis_steps(record.id);
    if (!steps.ok()) return steps.error();
    for (DiagnosisStep& step : *steps) book->steps_[step.name] = std::move(step.result);
    return book;
  }
  const auto added = book->write([&](Desk::Turn& turn) {
    book->record_.created_ms = turn.unix_ms;
    return turn.store.add_diagnosis(book->record_);
  });
  if (!added.ok()) return added.error();
  return book;
}

gap::StepMemory DiagnosisBook::memory() {
  return {.find = [this](const std::string& name) -> std::optional<std::string> {
            const auto known = steps_.find(name);
            return known == steps_.end() ? std::nullopt : std::optional(known->second);
          },
          .keep = [this](const std::string& name, const std::string& bytes) {
            if (!kept_.ok()) return;
            kept_ = write([&](Desk::Turn& turn) { return turn.store.add_diagnosis_step(record_.id, {name, turn.unix_ms, bytes}); });
          }};
}

Result<void> DiagnosisBook::end(const v1::Diagnosis& diagnosis) {
  if (!kept_.ok()) return kept_;
  const std::string json = json_of(diagnosis);
  return write([&](Desk::Turn& turn) { return turn.store.end_diagnosis(record_.id, json, turn.unix_ms); });
}

Result<v1::Diagnosis> stored_diagnosis(Reader& reader, const DiagnosisRecord& record) {
  auto diagnosis = from_json<v1::Diagnosis>(record.result, "diagnosis");
  if (!diagnosis.ok()) return diagnosis;
  std::string shrinkage = record.shrinkage;
  if (shrinkage.empty() && record.held_out.empty()) {
    const auto all = reader.diagnoses();
    if (!all.ok()) return all.error();
    for (const DiagnosisRecord& other : *all) {
      const bool same = other.observations == record.observations && other.bank == record.bank && other.kernels == record.kernels && other.method == record.method &&
                        other.options == record.options;
      if (same && shrinkage.empty()) shrinkage = other.shrinkage;
    }
  }
  if (shrinkage.empty()) return diagnosis;
  auto measured = from_json<v1::Shrinkage>(shrinkage, "shrinkage");
  if (!measured.ok()) return measured.error();
  *diagnosis->mutable_shrinkage() = std::move(*measured);
  return diagnosis;
}

}  // namespace regolab
