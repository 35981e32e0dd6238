/// From a SubmitRequest to what queue and store take in. Pure: no desk, no store.
#pragma once
#include <string>
#include <vector>

#include "regolab/v1/lab.pb.h"
#include "scheduler/queue/job_queue.h"
#include "store/records.h"

namespace regolab {

struct Submission {
  std::vector<v1::Diagnostic> diagnostics;  ///< not empty: refused
  v1::DesignSummary summary;                ///< without what only the store knows
  ExperimentRecord record;                  ///< without id, label and time
  std::vector<Wish> wishes;
};

Submission prepare(const v1::SubmitRequest& request);

/// "article-l32-3f9a1c": the name made safe to type, and the digest's first digits.
std::string label_of(const std::string& name, const std::string& digest);

}  // namespace regolab
