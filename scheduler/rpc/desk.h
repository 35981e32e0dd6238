/// The one thread that owns the queue and the writing side of the store. Work is posted to it, done in order, committed in
/// groups; answers go out after the commit. A commit that fails is treated as a crash: the queue is read again from the
/// store.
#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "scheduler/queue/job_queue.h"
#include "scheduler/rpc/book.h"
#include "store/store.h"

namespace regolab {

class Desk {
 public:
  /// What work sees. Valid only while it runs.
  struct Turn {
    JobQueue& queue;
    Store& store;
    Book& book;
    Millis now;                           ///< steady
    std::int64_t unix_ms;                 ///< wall clock, for people
    bool read_only;                       ///< the disk is full: nothing may be changed
    Effects effects;                      ///< filled by the queue; made durable when the work returns
    Result<void> rows;                    ///< outcome of rows the work wrote by itself, after begin()
    std::function<Result<void>()> begin;  ///< before the work writes rows by itself
  };
  using Answer = std::function<void()>;  ///< after the commit; may be empty
  using Work = std::function<Answer(Turn&)>;
  using Refusal = std::function<void(const Error&)>;  ///< instead: nothing of the work has happened
  enum class Need { kRead, kWrite };                  ///< kWrite is refused at once while the disk is full

  struct Options {
    QueuePolicy policy;
    std::function<void(const Error&)> on_fatal;   ///< the file can no longer be trusted: must end the process
    std::function<void(bool serving)> on_health;  ///< false while the disk is full
  };
  static Result<std::unique_ptr<Desk>> open(std::unique_ptr<Store> store, Options options);
  ~Desk();
  /// Work posted before waits until then.
  void start();

  /// Either the work's answer or `refused` is called, once. Any thread.
  void post(Need need, Work work, Refusal refused);
  /// post() and wait: the work's own outcome if it was committed. Never from the desk's thread.
  Result<void> ask(Need need, std::function<Result<void>(Turn&)> work);

  /// A call held until there is an order for its worker. `answer` is called once, on the desk's thread, after the commit.
  struct HeldCall {
    std::string worker;
    std::uint64_t id = 0;  ///< unique per call
    bool idle = false;
    Millis until = 0;
    std::function<void(const std::optional<Order>&)> answer;  ///< nullopt: the scheduler goes away
  };
  // On the desk's thread:
  void hold(HeldCall call);
  void let_go(const std::string& worker, std::uint64_t id);  ///< the caller of that very call has gone

  /// Called on the desk's thread after each batch, with the experiments that have new committed events; `periodic` about
  /// once a second. Register before any work is posted.
  using Listener = std::function<void(Turn&, const std::set<ExperimentId>& touched, bool periodic)>;
  void listen(Listener listener) { listener_ = std::move(listener); }

  const ArtifactFiles& files() const { return store_->files(); }
  void stop();  ///< held calls are answered; work still queued is refused

 private:
  struct Posted {
    Need need;
    Work work;
    Refusal refused;
  };
  struct Pending {
    Answer answer;
    Refusal refused;
  };
  Desk(std::unique_ptr<Store> store, Options options);
  Result<void> load();
  void run(const std::stop_token& stop);
  std::deque<Posted> next_batch(const std::stop_token& stop);
  void run_batch(std::deque<Posted> batch);
  Result<void> flush(Turn& turn);
  Result<void> begin();
  void serve_held(Turn& turn, std::vector<Pending>& pending);
  std::optional<HeldCall> take_held(const std::string& worker);
  void tick(Turn& turn);
  void keep_house(bool idle);
  void sweep(std::int64_t unix_ms);
  void recover(const Error& error);
  void probe_disk(Millis now);
  void answer_all_held(const std::optional<Order>& order);

  std::unique_ptr<Store> store_;
  Options options_;
  std::unique_ptr<JobQueue> queue_;
  std::unique_ptr<Book> book_;
  Listener listener_;
  bool in_transaction_ = false;
  bool read_only_ = false;
  std::set<ExperimentId> touched_;    ///< in this batch
  std::vector<std::string> revoked_;  ///< workers, in this batch
  Millis ticked_at_ = 0, probe_at_ = 0, listened_at_ = 0, swept_at_ = 0, worked_at_ = 0;
  std::map<std::string, HeldCall> held_;       ///< by worker
  std::map<std::uint64_t, std::string> idle_;  ///< of them, the idle ones by call id: first come, first served

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Posted> inbox_;  ///< guarded by mutex_
  bool closed_ = false;       ///< guarded by mutex_
  std::jthread thread_;       ///< last: uses all of the above
};

}  // namespace regolab
