#include "scheduler/rpc/watch.h"

#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "scheduler/rpc/experiments.h"
#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/status_view.h"

namespace regolab {
namespace {
constexpr int kPage = 64;  // events read at once
}

/// What a stream still has to say. Filled by the desk's thread, emptied by gRPC's; the stream may end at any time.
class Watcher {
 public:
  class Stream;

  Watcher(std::string label, std::uint64_t from_seq)
      : label_(std::move(label)), next_seq_(std::max<std::uint64_t>(from_seq, 1)) {}

  bool open() const {
    const std::lock_guard lock(mutex_);
    return stream_ != nullptr;
  }
  /// On the desk's thread: what is new since the last time.
  void feed(Desk::Turn& turn, bool with_progress);
  void end(const grpc::Status& status);

  const std::string& label() const { return label_; }
  ExperimentId id{};  ///< on the desk's thread, as the next
  bool fresh = true;  ///< has not been fed yet

 private:
  void start_next();  ///< with mutex_ held
  const std::string label_;
  std::uint64_t next_seq_;  ///< on the desk's thread
  mutable std::mutex mutex_;
  Stream* stream_ = nullptr;             ///< guarded by mutex_, as are all below
  std::deque<v1::WatchEvent> outgoing_;  ///< the first one is being written if writing_
  bool writing_ = false;
  bool finished_ = false;
  std::optional<grpc::Status> ending_;  ///< once everything is out
  friend class Stream;
};

class Watcher::Stream final : public grpc::ServerWriteReactor<v1::WatchEvent> {
 public:
  explicit Stream(std::shared_ptr<Watcher> watcher) : watcher_(std::move(watcher)) {
    const std::lock_guard lock(watcher_->mutex_);
    watcher_->stream_ = this;
  }
  void OnWriteDone(bool ok) override {
    const std::lock_guard lock(watcher_->mutex_);
    watcher_->writing_ = false;
    watcher_->outgoing_.pop_front();
    if (!ok)
      watcher_->ending_ = grpc::Status(grpc::StatusCode::CANCELLED, "the reader has gone"), watcher_->outgoing_.clear();
    watcher_->start_next();
  }
  void OnCancel() override { watcher_->end({grpc::StatusCode::CANCELLED, "the reader has gone"}); }
  void OnDone() override {
    {
      const std::lock_guard lock(watcher_->mutex_);
      watcher_->stream_ = nullptr;
    }
    delete this;
  }

 private:
  std::shared_ptr<Watcher> watcher_;
};

void Watcher::start_next() {
  if (!stream_ || writing_ || finished_) return;
  if (!outgoing_.empty()) {
    writing_ = true;
    stream_->StartWrite(&outgoing_.front());
  } else if (ending_) {
    finished_ = true;
    stream_->Finish(*ending_);
  }
}

void Watcher::end(const grpc::Status& status) {
  const std::lock_guard lock(mutex_);
  if (!ending_) ending_ = status;
  while (!status.ok() && outgoing_.size() > (writing_ ? 1U : 0U)) outgoing_.pop_back();
  start_next();
}

void Watcher::feed(Desk::Turn& turn, bool with_progress) {
  {
    const std::lock_guard lock(mutex_);
    if (!stream_ || ending_ || outgoing_.size() >= kPage) return;  // a slow reader gets the rest later
  }
  const auto events = turn.store.events(id, next_seq_, kPage);
  if (!events.ok()) return end(to_grpc(events.error()));
  const v1::ExperimentStatus status = status_of(id, turn);
  const bool over = status.state() != "running" && events->size() < kPage;
  const std::lock_guard lock(mutex_);
  for (const EventRecord& event : *events) {
    v1::WatchEvent& out = outgoing_.emplace_back();
    out.set_seq(event.seq);
    out.set_text(event.text);
    *out.mutable_status() = status;
    next_seq_ = event.seq + 1;
  }
  if (events->empty() && (with_progress || over)) {
    v1::WatchEvent& out = outgoing_.emplace_back();
    out.set_seq(next_seq_ - 1);
    out.set_progress_only(true);
    *out.mutable_status() = status;
  }
  if (over) ending_ = grpc::Status::OK;
  start_next();
}

WatchHub::WatchHub(Desk& desk) : desk_(desk) {
  desk_.listen([this](Desk::Turn& turn, const std::set<ExperimentId>& touched, bool periodic) {
    on_commit(turn, touched, periodic);
  });
}

WatchHub::~WatchHub() = default;

grpc::ServerWriteReactor<v1::WatchEvent>* WatchHub::open(const std::string& label, std::uint64_t from_seq) {
  auto watcher = std::make_shared<Watcher>(label, from_seq);
  auto* stream = new Watcher::Stream(watcher);
  desk_.post(
      Desk::Need::kRead,
      [this, watcher](Desk::Turn& turn) -> Desk::Answer {
        const ExperimentRecord* record = turn.book.find_label(watcher->label());
        if (!record) {
          watcher->end(to_grpc(no_such_experiment(watcher->label())));
          return {};
        }
        watcher->id = record->id;
        watchers_.push_back(watcher);  // fed after the commit: nothing is told that may yet be rolled back
        return {};
      },
      [watcher](const Error& error) { watcher->end(to_grpc(error)); });
  return stream;
}

void WatchHub::on_commit(Desk::Turn& turn, const std::set<ExperimentId>& touched, bool periodic) {
  watchers_.remove_if([](const auto& watcher) { return !watcher->open(); });
  for (const auto& watcher : watchers_) {
    if (!periodic && !watcher->fresh && !touched.contains(watcher->id)) continue;
    watcher->feed(turn, periodic || watcher->fresh);
    watcher->fresh = false;
  }
}

void WatchHub::close_all() {
  (void)desk_
      .ask(Desk::Need::kRead,
           [this](Desk::Turn&) -> Result<void> {
             for (const auto& watcher : watchers_)
               watcher->end({grpc::StatusCode::UNAVAILABLE, "the scheduler is shutting down"});
             return {};
           })
      .ok();
}

}  // namespace regolab
