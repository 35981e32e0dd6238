#include "scheduler/rpc/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "digest/sha256.h"
#include "rpc/convert.h"
#include "scheduler/rpc/grpc_status.h"

namespace regolab {
namespace {

constexpr Millis kLongestIdleHold = 20'000;
constexpr std::size_t kLongestName = 128;

Result<WorkerReport> report_of(const v1::SyncRequest& in) {
  if (in.worker().empty() || in.worker().size() > kLongestName) {
    return invalid("worker name refused (1 to 128 characters expected)");
  }
  WorkerReport report{in.worker(), in.seq(), in.draining(), WorkerIdle{}};
  if (in.slot().has_running()) {
    const v1::Running& r = in.slot().running();
    if (!r.checkpoint().empty() && !is_digest(r.checkpoint()))
      return invalid("checkpoint digest refused (64 hex digits expected)");
    report.slot = WorkerRunning{JobId{r.job()},
                                LeaseToken{r.lease_token()},
                                {r.phase(), std::clamp(r.fraction(), 0.0, 1.0), r.steps(), r.sphere_steps_per_s()},
                                r.checkpoint()};
  } else if (in.slot().has_finished()) {
    const v1::Finished& f = in.slot().finished();
    WorkerFinished finished{JobId{f.job()}, LeaseToken{f.lease_token()}, JobFailure{}, f.bed(), f.wall_s(), f.steps()};
    if (f.has_result()) {
      auto result = from_proto(f.result());
      if (!result.ok()) return result.error();
      finished.outcome = std::make_shared<const StageResult>(std::move(*result));
    } else if (f.has_error() && v1::ErrorClass_IsValid(f.error().class_())) {
      finished.outcome = JobFailure{static_cast<FailureClass>(f.error().class_()), f.error().text().substr(0, 4096)};
    } else {
      return invalid("report refused (neither a result nor an error of a known class)");
    }
    if (!f.bed().empty() && !is_digest(f.bed())) return invalid("bed digest refused (64 hex digits expected)");
    report.slot = std::move(finished);
  }
  return report;
}

void put_order(const Order& order, v1::SyncReply& out) {
  if (const auto* start = std::get_if<OrderStart>(&order)) {
    v1::Start& s = *out.mutable_start();
    s.set_job(static_cast<std::uint64_t>(start->job));
    s.set_lease_token(static_cast<std::uint64_t>(start->token));
    *s.mutable_spec() = to_proto(start->spec);
    s.set_bed(start->bed);
    s.set_checkpoint(start->checkpoint);
  } else if (const auto* drop = std::get_if<OrderDrop>(&order)) {
    out.mutable_drop()->set_why(drop->why);
  } else if (std::holds_alternative<OrderLeave>(order)) {
    out.mutable_leave();
  } else {
    out.mutable_keep();
  }
}

/// One call, until gRPC is done with it.
class SyncCall final : public grpc::ServerUnaryReactor {
 public:
  SyncCall(Desk& desk, std::string worker, v1::SyncReply* reply)
      : desk_(desk), worker_(std::move(worker)), reply_(reply), id_(next_id_++) {}

  std::uint64_t id() const { return id_; }
  void answer(const Order& order, Millis lease_ttl, std::size_t workers) {
    put_order(order, *reply_);
    reply_->set_lease_ttl_ms(static_cast<std::uint32_t>(lease_ttl));
    // A report a second while there are few workers; rarer when many would ask, but three within a lease.
    const Millis pace = std::min(std::max<Millis>(1000, static_cast<Millis>(2 * workers)), lease_ttl / 3);
    reply_->set_next_sync_in_ms(static_cast<std::uint32_t>(pace));
    Finish(grpc::Status::OK);
  }
  void refuse(const Error& error) { Finish(to_grpc(error)); }
  void OnCancel() override {
    desk_.post(
        Desk::Need::kRead,
        [&desk = desk_, worker = worker_, id = id_](Desk::Turn&) -> Desk::Answer {
          desk.let_go(worker, id);
          return {};
        },
        [](const Error&) {});
  }
  void OnDone() override { delete this; }

 private:
  static inline std::atomic<std::uint64_t> next_id_ = 1;
  Desk& desk_;
  const std::string worker_;
  v1::SyncReply* reply_;
  const std::uint64_t id_;
};

/// The right to finish a call, used up by its first use: a held call may be answered and refused at once when a commit
/// fails.
class Ticket {
 public:
  explicit Ticket(SyncCall* call) : call_(call) {}
  SyncCall* use() { return std::exchange(call_, nullptr); }
  std::uint64_t id() const { return call_->id(); }

 private:
  SyncCall* call_;
};

/// A finished settle stage names a bed that is stored; a checkpoint that is not stored is not mentioned.
Result<void> check_artifacts(WorkerReport& report, Desk::Turn& turn) {
  if (auto* run = std::get_if<WorkerRunning>(&report.slot)) {
    if (!run->checkpoint.empty() && (turn.read_only || !turn.store.knows_artifact(run->checkpoint))) run->checkpoint.clear();
  }
  const auto* done = std::get_if<WorkerFinished>(&report.slot);
  if (!done) return {};
  if (turn.read_only) {
    return Error{Code::kResourceExhausted,
                 "the result cannot be stored now (the disk is full), free some space; it is asked for again"};
  }
  const JobQueue::Job* job = turn.queue.find(done->job);
  const auto* result = std::get_if<std::shared_ptr<const StageResult>>(&done->outcome);
  if (!job || !result) return {};
  const bool leaves_bed = job->identity.spec.kind == StageKind::kSettle && (*result)->end == StageEnd::kCompleted;
  if (leaves_bed && !turn.store.knows_artifact(done->bed)) {
    return Error{Code::kFailedPrecondition, "the bed of job " + std::to_string(static_cast<std::uint64_t>(done->job)) +
                                                " is not stored, upload it before reporting"};
  }
  if (!leaves_bed && !done->bed.empty()) return invalid("report refused (only a completed settle stage leaves a bed)");
  return {};
}

}  // namespace

grpc::ServerUnaryReactor* WorkerPoolService::Sync(grpc::CallbackServerContext*, const v1::SyncRequest* request,
                                                  v1::SyncReply* reply) {
  auto* call = new SyncCall(desk_, request->worker(), reply);
  if (request->physics_version() != kPhysicsVersion) {
    call->refuse({Code::kFailedPrecondition,
                  "worker refused (its physics version is " + std::to_string(request->physics_version()) +
                      ", this scheduler's " + std::to_string(kPhysicsVersion) + "), use worker and scheduler of one build"});
    return call;
  }
  auto parsed = report_of(*request);
  if (!parsed.ok()) {
    call->refuse(parsed.error());
    return call;
  }
  auto report = std::make_shared<WorkerReport>(std::move(*parsed));
  auto ticket = std::make_shared<Ticket>(call);
  const auto refuse = [ticket](const Error& error) {
    if (SyncCall* mine = ticket->use()) mine->refuse(error);
  };
  desk_.post(
      Desk::Need::kRead,
      [this, ticket, refuse, report, wanted = Millis{request->hold_ms()}](Desk::Turn& turn) -> Desk::Answer {
        if (const auto fit = check_artifacts(*report, turn); !fit.ok())
          return [refuse, error = fit.error()] { refuse(error); };
        const bool running = std::holds_alternative<WorkerRunning>(report->slot);
        const bool idle = std::holds_alternative<WorkerIdle>(report->slot);
        std::optional<Order> order = OrderKeep{};  // a full disk: nothing can be given away
        if (!turn.read_only || running) order = turn.queue.exchange(*report, turn.now, turn.effects);
        const auto answer = [ticket, ttl = turn.queue.policy().lease_ttl,
                             workers = turn.queue.workers(turn.now, kLongestIdleHold)](const Order& given) {
          if (SyncCall* mine = ticket->use()) mine->answer(given, ttl, workers);
        };
        if (order) return [answer, given = std::move(*order)] { answer(given); };
        const Millis hold = std::min(wanted, idle ? kLongestIdleHold : turn.queue.policy().lease_ttl / 3);
        desk_.hold({report->worker, ticket->id(), idle, turn.now + hold, [answer, refuse](const std::optional<Order>& late) {
                      if (late)
                        answer(*late);
                      else
                        refuse({Code::kUnavailable, "the scheduler is shutting down"});
                    }});
        return {};
      },
      refuse);
  return call;
}

}  // namespace regolab
