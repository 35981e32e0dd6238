/// Ctrl-C and SIGTERM as a stop token, so that a blocked call can be cancelled and children can be ended in order.
#pragma once
#include <stop_token>

namespace regolab::client {

/// Call once, before any thread exists: blocks SIGINT, SIGTERM and SIGHUP everywhere and waits for them on a thread of its
/// own. The first one requests a stop; the second one ends the process at once with code 130 (children die with it).
void watch_signals();

/// Stopped by the first signal.
std::stop_token interrupted();

}  // namespace regolab::client
