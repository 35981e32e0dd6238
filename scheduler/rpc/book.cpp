#include "scheduler/rpc/book.h"

namespace regolab {

void Book::add(ExperimentRecord record) {
  by_label_[record.label] = record.id;
  by_request_[record.request_id] = record.id;
  by_digest_[record.digest] = record.id;
  record.design_yaml.clear();
  record.attachments.clear();
  record.levels.clear();
  records_[record.id] = std::move(record);
}

void Book::change(ExperimentId id, ExperimentState state, std::int64_t unix_ms) {
  const auto found = records_.find(id);
  if (found == records_.end()) return;  // being submitted: its record comes with the same state
  found->second.state = state;
  if (state == ExperimentState::kRunning)
    found->second.ended_ms.reset();
  else
    found->second.ended_ms = unix_ms;
}

const ExperimentRecord* Book::find(ExperimentId id) const {
  const auto found = records_.find(id);
  return found == records_.end() ? nullptr : &found->second;
}

const ExperimentRecord* Book::get(const std::map<std::string, ExperimentId>& index, const std::string& key) const {
  const auto found = index.find(key);
  return found == index.end() ? nullptr : find(found->second);
}

const ExperimentRecord* Book::find_label(const std::string& label) const { return get(by_label_, label); }
const ExperimentRecord* Book::find_request(const std::string& request_id) const { return get(by_request_, request_id); }
const ExperimentRecord* Book::find_digest(const std::string& digest) const { return get(by_digest_, digest); }

void Book::learn(const StageSpec& spec, double wall_s) {
  Mean& mean = times_[{spec.kind, spec.numerics.clusters}];
  mean.sum += wall_s;
  ++mean.n;
}

std::optional<double> Book::expected_s(const StageSpec& spec) const {
  if (const auto same = times_.find({spec.kind, spec.numerics.clusters}); same != times_.end()) {
    return same->second.sum / same->second.n;
  }
  for (const auto& [key, mean] : times_) {
    if (key.first == spec.kind) return mean.sum / mean.n * spec.numerics.clusters / key.second;
  }
  return std::nullopt;
}

}  // namespace regolab
