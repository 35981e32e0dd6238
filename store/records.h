/// What the store keeps of an experiment beside its jobs.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "vocab/job.h"
#include "vocab/result_table.h"

namespace regolab {

struct ResponseRecord {
  std::string id;                        ///< observation id
  std::string unit;                      ///< SI
  StageKind stage = StageKind::kFabric;  ///< what measures it

  bool operator==(const ResponseRecord&) const = default;
};

struct ExperimentRecord {
  ExperimentId id{};
  std::string label;       ///< what people type
  std::string name;        ///< from the design
  std::string request_id;  ///< of the submission
  std::string digest;      ///< of the resolved design
  std::string design_yaml;
  std::string file_name;
  std::map<std::string, std::string> attachments;  ///< name -> bytes
  std::string array;
  std::string summary;  ///< JSON
  ExperimentState state = ExperimentState::kRunning;
  std::int64_t created_ms = 0;  ///< Unix time
  std::optional<std::int64_t> ended_ms;
  std::vector<TableFactor> factors;
  std::vector<std::vector<int>> levels;  // [n_points][n_factors] 0-based; row p is point p + 1
  std::vector<ResponseRecord> responses;
};

/// All a queue and a status need after a restart.
struct Snapshot {
  struct Study {
    ExperimentRecord record;  ///< without design text, attachments and levels
    std::uint64_t next_seq = 1;
  };
  std::vector<JobRecord> jobs;  ///< parents first
  std::vector<Study> studies;
  std::vector<JobLink> links;
};

struct EventRecord {
  std::uint64_t seq = 0;
  std::string text;
};

/// A stage of an experiment with what became of it.
struct StoredStage {
  JobLink link;
  JobRecord record;
  std::optional<std::string> end_name;
};

/// A surrogate, as its file.
struct ModelRecord {
  std::string id;
  std::string name;
  std::int64_t created_ms = 0;  ///< Unix time
  std::string file;
};

/// A diagnosis, finished or not. What it says is JSON; digests are SHA-256.
struct DiagnosisRecord {
  std::string id;  ///< digest of all that the answer is a function of
  std::string case_name;
  std::int64_t created_ms = 0;  ///< Unix time
  std::optional<std::int64_t> ended_ms;
  std::string observations, bank, kernels, method;  ///< digests
  std::string options;
  std::string held_out;      ///< groups that the fit did not see; empty: it saw all
  std::string measurements;  ///< the file as it was handed in
  std::string result;        ///< empty until it has ended
  std::string shrinkage;     ///< what new runs measured; empty without
};

struct DiagnosisStep {
  std::string name;  ///< "evidence: cohesion"
  std::int64_t done_ms = 0;
  std::string result;
};

struct StoredResponse {
  int point = 0;
  std::uint64_t seed = 0;
  std::string id;
  double value = 0;  ///< SI
};

}  // namespace regolab
