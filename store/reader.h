/// The reading side: an own read-only connection, short transactions, any thread (one Reader per thread).
#pragma once
#include <string>
#include <vector>

#include "store/database.h"
#include "store/records.h"

namespace regolab {

class Reader {
 public:
  static Result<Reader> open(const std::string& path);

  /// Factors, levels and responses; kNotFound when there is no such experiment.
  Result<ExperimentRecord> design(const std::string& label);
  Result<std::vector<StoredStage>> stages(ExperimentId id);        ///< in the order submitted
  Result<std::vector<StoredResponse>> responses(ExperimentId id);  ///< of stages that completed
  /// Bit for bit what was accepted; kNotFound when the job has none.
  Result<StageResult> result(JobId job);
  /// Newest first; without their files.
  Result<std::vector<ModelRecord>> models();
  /// By id, or the start of one; kNotFound.
  Result<ModelRecord> model(const std::string& id);
  /// Newest first; without measurements.
  Result<std::vector<DiagnosisRecord>> diagnoses();
  /// By id, or the start of one; kNotFound, kInvalidArgument when several start so.
  Result<DiagnosisRecord> diagnosis(const std::string& id);
  /// Of one diagnosis, in the order they were done.
  Result<std::vector<DiagnosisStep>> diagnosis_steps(const std::string& id);

 private:
  explicit Reader(Database db) : db_(std::move(db)) {}
  Result<void> read_curves(JobId job, StageResult& result);
  Database db_;
};

}  // namespace regolab
