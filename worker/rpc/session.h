/// A worker's side of the exchange: what it says next, and what it does about the answer.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "worker/rpc/link.h"
#include "worker/rpc/stage_thread.h"

namespace regolab {

struct SessionOptions {
  std::string server;
  std::string name;  ///< unique per process
  StageThread::Options stage;
};

class Session {
 public:
  Session(SessionOptions options, StageFunction run);

  /// Until told to leave; the process's exit code.
  int run();
  /// Checkpoint, hand the job back, go. Any thread.
  void leave();

 private:
  using Clock = std::chrono::steady_clock;

  v1::SyncRequest next_request();
  void describe_running(v1::Running& running);
  void describe_finished(v1::Finished& finished);
  void act(const v1::SyncReply& reply);
  void begin(const v1::Start& start);
  void end_stage();
  bool retry_after(const Error& error);  ///< false: no use
  void pause();
  Result<std::string> get(const std::string& digest);

  const SessionOptions options_;
  const StageFunction run_;
  Link link_;
  std::atomic<bool> leaving_ = false;
  std::uint64_t seq_ = 0;
  std::optional<v1::SyncRequest> unanswered_;  ///< said again with the same seq until it is answered
  std::unique_ptr<StageThread> stage_;
  std::uint64_t job_ = 0, token_ = 0;
  Clock::time_point begun_{}, left_at_{};
  std::uint32_t next_sync_ms_ = 1000;
  std::string told_checkpoint_;
  std::optional<v1::Finished> finished_;  ///< to be reported
  bool gone_ = false;
  int exit_code_ = 0;
  std::chrono::milliseconds backoff_{100};
  std::mutex beds_mutex_;
  std::map<std::string, std::string> beds_;  ///< the last few, digest -> bytes; guarded by beds_mutex_
};

}  // namespace regolab
