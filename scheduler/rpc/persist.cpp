#include "scheduler/rpc/persist.h"

namespace regolab {
namespace {

struct Writer {
  const JobQueue& queue;
  Store& store;
  std::int64_t unix_ms;

  Result<void> operator()(const JobAdded& e) { return store.add_job(e.record); }
  Result<void> operator()(const JobChanged& e) { return store.change_job(e.job, e.status); }
  Result<void> operator()(const Linked& e) { return store.link(e.link); }
  Result<void> operator()(const ExperimentChanged& e) { return store.change_experiment(e.experiment, e.state, unix_ms); }
  Result<void> operator()(const AttemptStarted& e) { return store.start_attempt(e.job, e.token, e.worker, unix_ms); }
  Result<void> operator()(const AttemptEnded& e) { return store.end_attempt(e.token, e.outcome, e.detail, unix_ms); }
  Result<void> operator()(const ResultAccepted& e) {
    return store.accept_result({e.job, e.token, e.wall_s, e.steps, unix_ms}, *e.result);
  }
  Result<void> operator()(const ResultForgotten& e) { return store.forget_result(e.job); }
  Result<void> operator()(const EventNoted& e) {
    return store.add_event(e.experiment, e.seq, unix_ms, event_text(e, queue));
  }
  Result<void> operator()(const LeaseRevoked&) { return {}; }
};

}  // namespace

Result<void> persist(const Effects& effects, const JobQueue& queue, Store& store, std::int64_t unix_ms) {
  Writer writer{queue, store, unix_ms};
  for (const Effect& effect : effects) {
    if (auto done = std::visit(writer, effect); !done.ok()) return done;
  }
  return {};
}

void note_in_book(const Effects& effects, const JobQueue& queue, Book& book, std::int64_t unix_ms) {
  for (const Effect& effect : effects) {
    if (const auto* changed = std::get_if<ExperimentChanged>(&effect))
      book.change(changed->experiment, changed->state, unix_ms);
    if (const auto* accepted = std::get_if<ResultAccepted>(&effect)) {
      book.learn(queue.find(accepted->job)->identity.spec, accepted->wall_s);
    }
  }
}

}  // namespace regolab
