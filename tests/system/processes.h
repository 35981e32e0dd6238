/// Programs under test as child processes: started, killed, started again.
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace regolab::test {

using Command = std::vector<std::string>;

/// Started with its output in `log`; killed and reaped when the object goes.
class Process {
 public:
  Process(const Command& command, const std::string& log) {
    std::vector<char*> argv;
    for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    dup2(file, 1);
    dup2(file, 2);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~Process() {
    signal(SIGKILL);
    wait();
  }
  Process(const Process&) = delete;

  void signal(int number) const {
    if (!status_) ::kill(pid_, number);
  }
  /// The exit code, or -signal.
  int wait() {
    if (!status_) {
      int status = 0;
      waitpid(pid_, &status, 0);
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    return *status_;
  }
  bool running() {
    if (status_) return false;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == 0) return true;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return false;
  }

 private:
  pid_t pid_;
  std::optional<int> status_;
};

/// Starts a program again whenever it ends, until stopped.
class Supervisor {
 public:
  Supervisor(Command command, std::string log) : command_(std::move(command)), log_(std::move(log)) {
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        {
          const std::lock_guard lock(mutex_);
          if (!process_ || !process_->running()) process_ = std::make_unique<Process>(command_, log_), ++starts;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  void kill() { signal(SIGKILL); }
  void signal(int number) {
    const std::lock_guard lock(mutex_);
    if (process_) process_->signal(number);
  }
  /// Ends it in good order; the exit code.
  int stop() {
    thread_ = {};
    if (!process_) return 0;
    process_->signal(SIGTERM);
    return process_->wait();
  }
  std::atomic<int> starts = 0;

 private:
  const Command command_;
  const std::string log_;
  std::mutex mutex_;
  std::unique_ptr<Process> process_;  ///< guarded by mutex_
  std::jthread thread_;
};

inline std::string text_of(const std::string& file) {
  std::ifstream in{file};
  return {std::istreambuf_iterator<char>(in), {}};
}

inline bool eventually(const std::function<bool()>& holds, std::chrono::seconds limit = std::chrono::seconds(20)) {
  const auto until = std::chrono::steady_clock::now() + limit;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// The programs to test, from the build; REGOLAB_TEST_WORKER replaces the worker.
struct Programs {
  std::string scheduler = REGOLAB_SCHEDULER;
  std::string worker = std::getenv("REGOLAB_TEST_WORKER") ? std::getenv("REGOLAB_TEST_WORKER") : REGOLAB_WORKER;
};

}  // namespace regolab::test
