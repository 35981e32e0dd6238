/// What the scheduler remembers of experiments beside the queue: names, times, and how long stages take.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "scheduler/queue/job_queue.h"
#include "store/records.h"

namespace regolab {

class Book {
 public:
  void add(ExperimentRecord record);  ///< without design text and levels
  void change(ExperimentId id, ExperimentState state, std::int64_t unix_ms);

  const ExperimentRecord* find(ExperimentId id) const;
  const ExperimentRecord* find_label(const std::string& label) const;
  const ExperimentRecord* find_request(const std::string& request_id) const;
  const ExperimentRecord* find_digest(const std::string& digest) const;
  const std::map<ExperimentId, ExperimentRecord>& all() const { return records_; }

  /// A stage of this spec took so long.
  void learn(const StageSpec& spec, double wall_s);
  /// Mean over stages of the same kind and size; else over the kind, scaled by the number of clusters; nothing before the
  /// first.
  std::optional<double> expected_s(const StageSpec& spec) const;

 private:
  const ExperimentRecord* get(const std::map<std::string, ExperimentId>& index, const std::string& key) const;
  struct Mean {
    double sum = 0;
    int n = 0;
  };
  std::map<ExperimentId, ExperimentRecord> records_;
  std::map<std::string, ExperimentId> by_label_, by_request_, by_digest_;
  std::map<std::pair<StageKind, int>, Mean> times_;  ///< per kind and number of clusters
};

}  // namespace regolab
