/// One child process: started without fork (gRPC's threads forbid it), looked at without blocking, ended in order.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/outcome.h"

namespace regolab::client {

struct ChildEnd {
  bool by_signal = false;
  int code = 0;  ///< exit code, or the signal's number
};

class Child {
 public:
  struct Start {
    std::vector<std::string> command;  ///< [0] is the program's path
    std::filesystem::path log;         ///< stderr is appended here, and stdout unless it is piped
    bool pipe_stdout = false;
    std::filesystem::path input = "/dev/null";  ///< its stdin
    std::filesystem::path output = {};          ///< its stdout goes there, made anew; REQUIRES: not piped
  };

  Child() = default;
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  ~Child();  ///< closes the pipe; a child that still runs goes on

  /// In a process group of its own, so that a Ctrl-C at the terminal reaches this process alone, which then ends its
  /// children.
  Outcome start(const Start& start);

  bool running() const { return pid_ > 0 && !end_; }
  /// Its end, once it has ended.
  std::optional<ChildEnd> look();
  void send(int signal) const;
  /// Waits for the end; false when it still runs after `limit`.
  bool wait(std::chrono::milliseconds limit);
  /// The next line the child prints; nothing when it closed its stdout or `limit` passed. REQUIRES: pipe_stdout.
  std::optional<std::string> read_line(std::chrono::milliseconds limit);
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  int pipe_ = -1;
  std::optional<ChildEnd> end_;
};

/// The folder this program was started from: the other programs are beside it.
std::filesystem::path program_folder();

/// The last lines of a log, for messages; empty when there is nothing.
std::string tail_of(const std::filesystem::path& log, int lines);

}  // namespace regolab::client
