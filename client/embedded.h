/// Embedded mode: a scheduler and workers of our own, as child processes over a private socket.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "client/outcome.h"
#include "client/process.h"

namespace regolab::client {

class Embedded {
 public:
  struct Options {
    std::filesystem::path programs;  ///< folder of regolab-scheduler and regolab-worker
    std::filesystem::path database;  ///< empty = a temporary one, gone with this object
  };

  /// Starts a scheduler and waits until it listens. When it refuses (newer database, locked, no room), the outcome is its
  /// own message and exit code.
  static Outcome start(const Options& options, std::unique_ptr<Embedded>& started);

  /// Ends workers (they save where they are) and scheduler, and removes the socket.
  ~Embedded();
  Embedded(const Embedded&) = delete;
  Embedded& operator=(const Embedded&) = delete;

  const std::string& address() const { return address_; }
  /// Starts those that are not there yet.
  void have_workers(unsigned count);

  /// Stopped when a child is beyond help; failure() then says why.
  std::stop_token broken() const { return broken_.get_token(); }
  Outcome failure() const;

 private:
  /// A program that should run, and its present process.
  struct Kept {
    std::string name;
    Child::Start start;
    Child child;
    int failures_in_a_row = 0;
    std::chrono::steady_clock::time_point started{};
    std::chrono::steady_clock::time_point start_again{};
  };

  Embedded() = default;
  Outcome start_scheduler(const Options& options);
  void supervise(const std::stop_token& stop);
  void look_after(Kept& kept);
  void note_end(Kept& kept, const ChildEnd& end);
  void give_up(Outcome why);

  std::filesystem::path programs_;
  std::filesystem::path scratch_;  ///< 0700, holds the socket
  std::filesystem::path logs_;
  std::filesystem::path announced_;  ///< file that tells other clients of this database where we are
  std::string address_;
  std::stop_source broken_;
  mutable std::mutex mutex_;  // guards kept_, failure_
  std::vector<Kept> kept_;    ///< [0] is the scheduler
  Outcome failure_;
  std::jthread supervisor_;  ///< restarts children; it started them, so it must outlive them
};

/// The address of a scheduler that another embedded client runs on this database right now; empty when there is none.
std::string running_scheduler_of(const std::filesystem::path& database);

}  // namespace regolab::client
