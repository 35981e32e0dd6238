#include "scheduler/rpc/desk.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <set>

#include "scheduler/rpc/persist.h"

namespace regolab {
namespace {

constexpr std::chrono::milliseconds kTick{50};
constexpr std::size_t kGroup = 256;       // operations per commit
constexpr std::int64_t kLogPages = 1000;  // then the log moves into the file
constexpr Millis kProbeEvery = 2'000;     // of a full disk
constexpr Millis kListenEvery = 1'000;
constexpr Millis kSweepEvery = 60'000;
constexpr std::int64_t kUnreferencedMs = 600'000;  // an upload may wait so long for the report that names it

Millis steady_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}
std::int64_t wall_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

const Error kFull{Code::kResourceExhausted,
                  "nothing can be stored (the disk of the database is full), free some space; the scheduler "
                  "goes on by itself then"};
const Error kClosing{Code::kUnavailable, "the scheduler is shutting down, try again when it is back"};

}  // namespace

Desk::Desk(std::unique_ptr<Store> store, Options options) : store_(std::move(store)), options_(std::move(options)) {}

Result<std::unique_ptr<Desk>> Desk::open(std::unique_ptr<Store> store, Options options) {
  std::unique_ptr<Desk> desk{new Desk(std::move(store), std::move(options))};
  const auto token = desk->store_->next_boot(wall_ms() / 1000);
  if (!token.ok()) return token.error();
  desk->queue_ = std::make_unique<JobQueue>(desk->options_.policy, *token);
  if (auto loaded = desk->load(); !loaded.ok()) return loaded.error();
  desk->store_->remove_orphans();
  desk->swept_at_ = steady_ms();
  return desk;
}

void Desk::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Desk::~Desk() { stop(); }

void Desk::stop() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

Result<void> Desk::load() {
  auto snapshot = store_->load();
  if (!snapshot.ok()) return snapshot.error();
  auto queue = std::make_unique<JobQueue>(options_.policy, queue_->last_token());
  auto book = std::make_unique<Book>();
  for (JobRecord& record : snapshot->jobs) {
    if (record.status.end) book->learn(record.identity.spec, record.status.wall_s);
    queue->restore(std::move(record));
  }
  for (Snapshot::Study& study : snapshot->studies) {
    queue->restore(study.record.id, study.record.state, study.next_seq);
    book->add(std::move(study.record));
  }
  for (const JobLink& link : snapshot->links) queue->restore(link);
  queue->restored(steady_ms());
  queue_ = std::move(queue);
  book_ = std::move(book);
  return {};
}

void Desk::post(Need need, Work work, Refusal refused) {
  {
    const std::lock_guard lock(mutex_);
    if (!closed_) {
      inbox_.push_back({need, std::move(work), std::move(refused)});
      arrived_.notify_one();
      return;
    }
  }
  refused(kClosing);
}

Result<void> Desk::ask(Need need, std::function<Result<void>(Turn&)> work) {
  auto promise = std::make_shared<std::promise<Result<void>>>();
  auto future = promise->get_future();
  post(
      need,
      [promise, work = std::move(work)](Turn& turn) -> Answer {
        return [promise, done = work(turn)] { promise->set_value(done); };
      },
      [promise](const Error& error) { promise->set_value(error); });
  return future.get();
}

void Desk::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    auto batch = next_batch(stop);
    const bool idle = batch.empty();
    run_batch(std::move(batch));
    keep_house(idle);
  }
  answer_all_held(std::nullopt);
  std::deque<Posted> left;
  {
    const std::lock_guard lock(mutex_);
    left.swap(inbox_);
  }
  for (Posted& posted : left) posted.refused(kClosing);
}

std::deque<Desk::Posted> Desk::next_batch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, stop, kTick, [this] { return !inbox_.empty(); });
  std::deque<Posted> batch;
  if (inbox_.size() <= kGroup) {
    batch.swap(inbox_);
  } else {
    std::move(inbox_.begin(), inbox_.begin() + kGroup, std::back_inserter(batch));
    inbox_.erase(inbox_.begin(), inbox_.begin() + kGroup);
  }
  return batch;
}

void Desk::run_batch(std::deque<Posted> batch) {
  Turn turn{*queue_, *store_, *book_, steady_ms(), wall_ms(), read_only_, {}, {}, [this] { return begin(); }};
  touched_.clear();
  revoked_.clear();
  std::vector<Pending> pending;
  Result<void> outcome;
  if (!read_only_) {
    tick(turn);
    outcome = flush(turn);
  }
  while (outcome.ok() && !batch.empty()) {
    Posted posted = std::move(batch.front());
    batch.pop_front();
    if (read_only_ && posted.need == Need::kWrite) {
      posted.refused(kFull);
      continue;
    }
    Answer answer = posted.work(turn);
    pending.push_back({std::move(answer), std::move(posted.refused)});
    outcome = turn.rows.ok() ? flush(turn) : turn.rows;
  }
  if (outcome.ok()) {
    serve_held(turn, pending);
    outcome = flush(turn);
  }
  if (outcome.ok() && in_transaction_) outcome = store_->commit();
  if (!outcome.ok()) {
    store_->rollback();
    in_transaction_ = false;
    for (const Pending& p : pending) p.refused(outcome.error());
    {
      const std::lock_guard lock(mutex_);  // what was not begun keeps its place
      inbox_.insert(inbox_.begin(), std::make_move_iterator(batch.begin()), std::make_move_iterator(batch.end()));
    }
    return recover(outcome.error());
  }
  in_transaction_ = false;
  for (const Pending& p : pending) {
    if (p.answer) p.answer();
  }
  const bool periodic = turn.now - listened_at_ >= kListenEvery;
  if (listener_ && (periodic || !pending.empty() || !touched_.empty())) {
    if (periodic) listened_at_ = turn.now;
    listener_(turn, touched_, periodic);
  }
}

/// Effects so far become rows of the open transaction.
Result<void> Desk::flush(Turn& turn) {
  if (turn.effects.empty()) return {};
  if (auto begun = begin(); !begun.ok()) return begun;
  auto done = persist(turn.effects, *queue_, *store_, turn.unix_ms);
  if (!done.ok()) return done;
  note_in_book(turn.effects, *queue_, *book_, turn.unix_ms);
  for (const Effect& effect : turn.effects) {
    if (const auto* event = std::get_if<EventNoted>(&effect)) touched_.insert(event->experiment);
    if (const auto* revoked = std::get_if<LeaseRevoked>(&effect)) revoked_.push_back(revoked->worker);
  }
  turn.effects.clear();
  return {};
}

Result<void> Desk::begin() {
  if (in_transaction_) return {};
  auto begun = store_->begin();
  in_transaction_ = begun.ok();
  return begun;
}

void Desk::tick(Turn& turn) {
  if (turn.now - ticked_at_ < kTick.count()) return;
  ticked_at_ = turn.now;
  queue_->tick(turn.now, turn.effects);
}

/// After a commit that failed. What is in memory may be ahead of the file, so it is read again, as after a crash.
void Desk::recover(const Error& error) {
  spdlog::error("{}", error.text);
  const bool full = error.code == Code::kResourceExhausted;
  if (!full && error.code != Code::kAborted && error.code != Code::kUnavailable) return options_.on_fatal(error);
  if (full && !read_only_) {
    read_only_ = true;
    options_.on_health(false);
  }
  probe_at_ = steady_ms() + kProbeEvery;
  if (auto loaded = load(); !loaded.ok()) return options_.on_fatal(loaded.error());
  answer_all_held(OrderKeep{});  // they ask again
}

void Desk::probe_disk(Millis now) {
  probe_at_ = now + kProbeEvery;
  if (!store_->has_room().ok()) return;
  read_only_ = false;
  spdlog::info("there is room on the disk again");
  options_.on_health(true);
}

void Desk::keep_house(bool idle) {
  const Millis now = steady_ms();
  if (read_only_) {
    if (now >= probe_at_) probe_disk(now);
    return;
  }
  if (!idle) worked_at_ = now;
  const bool resting = now - worked_at_ > 2'000 && store_->log_pages() > 0;
  if (store_->log_pages() > kLogPages || resting) {
    const auto moved = store_->checkpoint(resting);  // a full disk only leaves the log longer
    if (!moved.ok() && moved.error().code == Code::kDataLoss) options_.on_fatal(moved.error());
  }
  if (now - swept_at_ > kSweepEvery) {
    swept_at_ = now;
    sweep(wall_ms());
  }
}

void Desk::sweep(std::int64_t unix_ms) {
  if (auto begun = store_->begin(); !begun.ok()) return recover(begun.error());
  const auto digests = store_->sweep(unix_ms - kUnreferencedMs);
  const auto committed = digests.ok() ? store_->commit() : Result<void>(digests.error());
  if (!committed.ok()) {
    store_->rollback();
    return recover(committed.error());
  }
  for (const std::string& digest : *digests) files().remove(digest);
}

}  // namespace regolab
