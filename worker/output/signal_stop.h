/// Ctrl-C as a request to stop: what runs saves its state and leaves.
#pragma once
#include <csignal>
#include <stop_token>
#include <thread>

namespace regolab {

/// While it lives, SIGINT and SIGTERM are held back from every thread started after it and turned into a stop request;
/// the second one ends the process at once with exit code 130. Make it before any other thread.
class SignalStop {
 public:
  SignalStop();
  SignalStop(const SignalStop&) = delete;
  SignalStop& operator=(const SignalStop&) = delete;
  ~SignalStop();

  std::stop_token token() const { return stop_.get_token(); }

 private:
  sigset_t before_{};
  std::stop_source stop_;
  std::jthread waiter_;
};

}  // namespace regolab
