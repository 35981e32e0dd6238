/// Diagnoses in the store: found by all that their answer is a function of, with the steps that are done.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "regolab/v1/lab.pb.h"
#include "scheduler/gap/steps.h"
#include "scheduler/rpc/bank_cache.h"
#include "scheduler/rpc/desk.h"
#include "store/reader.h"

namespace regolab {

/// Of the file as it was handed in, its map, and whether missing errors are assumed; not of its name.
std::string observations_digest(const v1::ImportRequest& measurements);

/// The row that a request asks for, found or to be made. `held_out`: groups left out of the fit.
DiagnosisRecord diagnosis_record(const v1::DiagnoseRequest& request, const HeldBank& bank, const std::string& case_name, const std::string& held_out);

/// One diagnosis under way. What it writes goes through the desk; reads have a connection of their own.
class DiagnosisBook {
 public:
  /// Finds the row, or adds it, and reads the steps done so far.
  static Result<std::unique_ptr<DiagnosisBook>> open(Desk& desk, const std::string& database, const DiagnosisRecord& record);

  const DiagnosisRecord& record() const { return record_; }
  bool finished() const { return record_.ended_ms.has_value(); }
  /// Of the steps; must not outlive this.
  gap::StepMemory memory();
  /// Why steps could not be kept, or the end; the first reason.
  Result<void> end(const v1::Diagnosis& diagnosis);

 private:
  DiagnosisBook(Desk& desk, DiagnosisRecord record) : desk_(desk), record_(std::move(record)) {}
  Result<void> write(const std::function<Result<void>(Desk::Turn&)>& rows);

  Desk& desk_;
  DiagnosisRecord record_;
  std::map<std::string, std::string> steps_;
  Result<void> kept_;
};

/// The result of a finished record, with what confirmed it: its own shrinkage, or that of the same question fitted without the held-out groups.
Result<v1::Diagnosis> stored_diagnosis(Reader& reader, const DiagnosisRecord& record);

std::string json_of(const google::protobuf::Message& message);

}  // namespace regolab
