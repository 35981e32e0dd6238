#include "worker/output/signal_stop.h"

#include <pthread.h>
#include <unistd.h>

#include <ctime>

namespace regolab {
namespace {

constexpr int kInterrupted = 130;

sigset_t stopping_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

SignalStop::SignalStop() {
  const sigset_t held = stopping_signals();
  pthread_sigmask(SIG_BLOCK, &held, &before_);
  waiter_ = std::jthread([held, &stop = stop_](std::stop_token leave) {
    const timespec look_up{.tv_sec = 0, .tv_nsec = 100'000'000};  // how long the destructor may have to wait
    while (!leave.stop_requested()) {
      if (sigtimedwait(&held, nullptr, &look_up) < 0) continue;
      if (!stop.request_stop()) _exit(kInterrupted);  // asked twice
    }
  });
}

SignalStop::~SignalStop() {
  waiter_ = {};
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace regolab
