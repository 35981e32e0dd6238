#include "scheduler/rpc/experiments.h"

#include <google/protobuf/util/json_util.h>

#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/status_view.h"

namespace regolab {
namespace {

/// How much of the study is stored already, and how many stages will step the DEM.
void count_jobs(const std::vector<Wish>& wishes, const JobQueue& queue, v1::DesignSummary& summary) {
  std::uint32_t stored = 0, dem = 0;
  std::set<std::string> counted;
  for (const Wish& wish : wishes) {
    const JobQueue::Job* job = queue.find_key(wish.key);
    const bool known = job && job->status.state == JobState::kSucceeded;
    if (known)
      ++stored;
    else if (wish.spec.kind != StageKind::kFabric && counted.insert(wish.key).second)
      ++dem;
  }
  summary.set_jobs(static_cast<std::uint32_t>(wishes.size()));
  summary.set_jobs_stored(stored);
  summary.set_dem_jobs(dem);
}

void put_diagnostics(const Submission& submission, v1::SubmitReply& reply) {
  for (const v1::Diagnostic& diagnostic : submission.diagnostics) *reply.add_diagnostics() = diagnostic;
}

}  // namespace

Error no_such_experiment(const std::string& label) {
  return {Code::kNotFound,
          "experiment '" + label + "' is not known here (not in this database), list them with `regolab status`"};
}

grpc::Status ExperimentsService::Validate(grpc::ServerContext*, const v1::SubmitRequest* request, v1::SubmitReply* reply) {
  const Submission submission = prepare(*request);
  put_diagnostics(submission, *reply);
  if (!submission.diagnostics.empty()) return grpc::Status::OK;
  *reply->mutable_summary() = submission.summary;
  return to_grpc(desk_.ask(Desk::Need::kRead, [&](Desk::Turn& turn) -> Result<void> {
    count_jobs(submission.wishes, turn.queue, *reply->mutable_summary());
    reply->set_already_known(turn.book.find_digest(submission.record.digest) != nullptr);
    return {};
  }));
}

grpc::Status ExperimentsService::Submit(grpc::ServerContext*, const v1::SubmitRequest* request, v1::SubmitReply* reply) {
  Submission submission = prepare(*request);
  put_diagnostics(submission, *reply);
  if (!submission.diagnostics.empty()) return grpc::Status::OK;
  *reply->mutable_summary() = submission.summary;
  return to_grpc(desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) { return take_in(submission, turn, *reply); }));
}

Result<void> ExperimentsService::take_in(Submission& submission, Desk::Turn& turn, v1::SubmitReply& reply) {
  ExperimentRecord& record = submission.record;
  count_jobs(submission.wishes, turn.queue, *reply.mutable_summary());
  const ExperimentRecord* known = turn.book.find_request(record.request_id);
  if (known && known->digest != record.digest) {
    return Error{Code::kAlreadyExists,
                 "request_id '" + record.request_id + "' refused (used for another design), choose a new one"};
  }
  if (!known) known = turn.book.find_digest(record.digest);
  if (known) {
    reply.set_experiment(known->label);
    reply.set_already_known(true);
    if (known->state == ExperimentState::kCancelled) turn.queue.retry(known->id, turn.now, turn.effects);
    return {};
  }
  record.id = turn.queue.submit(submission.wishes, turn.now, turn.effects);
  record.label = label_of(record.name, record.digest);
  record.created_ms = turn.unix_ms;
  record.summary.clear();
  (void)google::protobuf::util::MessageToJsonString(reply.summary(), &record.summary);
  turn.rows = turn.begin();
  if (turn.rows.ok()) turn.rows = turn.store.add_experiment(record);
  if (!turn.rows.ok()) return turn.rows;
  turn.book.add(record);
  reply.set_experiment(record.label);
  return {};
}

grpc::Status ExperimentsService::List(grpc::ServerContext*, const v1::ListRequest*, v1::ListReply* reply) {
  return to_grpc(desk_.ask(Desk::Need::kRead, [&](Desk::Turn& turn) -> Result<void> {
    for (const auto& [id, record] : turn.book.all()) *reply->add_experiments() = status_of(id, turn);
    return {};
  }));
}

grpc::Status ExperimentsService::Get(grpc::ServerContext*, const v1::GetRequest* request, v1::ExperimentStatus* reply) {
  return to_grpc(desk_.ask(Desk::Need::kRead, [&](Desk::Turn& turn) -> Result<void> {
    const ExperimentRecord* record = turn.book.find_label(request->experiment());
    if (!record) return no_such_experiment(request->experiment());
    *reply = status_of(record->id, turn);
    return {};
  }));
}

grpc::Status ExperimentsService::Cancel(grpc::ServerContext*, const v1::CancelRequest* request,
                                        v1::ExperimentStatus* reply) {
  return to_grpc(desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
    const ExperimentRecord* record = turn.book.find_label(request->experiment());
    if (!record) return no_such_experiment(request->experiment());
    turn.queue.cancel(record->id, turn.now, turn.effects);
    *reply = status_of(record->id, turn);
    return {};
  }));
}

grpc::Status ExperimentsService::Retry(grpc::ServerContext*, const v1::RetryRequest* request, v1::ExperimentStatus* reply) {
  return to_grpc(desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
    const ExperimentRecord* record = turn.book.find_label(request->experiment());
    if (!record) return no_such_experiment(request->experiment());
    turn.queue.retry(record->id, turn.now, turn.effects);
    *reply = status_of(record->id, turn);
    return {};
  }));
}

grpc::ServerWriteReactor<v1::WatchEvent>* ExperimentsService::Watch(grpc::CallbackServerContext*,
                                                                    const v1::WatchRequest* request) {
  return hub_.open(request->experiment(), request->from_seq());
}

}  // namespace regolab
