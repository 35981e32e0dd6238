#include "client/interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <thread>

namespace regolab::client {
namespace {

std::stop_source& source() {
  static std::stop_source stop;
  return stop;
}

}  // namespace

void watch_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, number);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal(SIGPIPE, SIG_IGN);  // a closed pipe is seen when writing
  source();
  std::thread([signals] {
    int number = 0;
    while (sigwait(&signals, &number) == 0) {
      if (!source().request_stop()) _exit(130);
    }
  }).detach();
}

std::stop_token interrupted() { return source().get_token(); }

}  // namespace regolab::client
