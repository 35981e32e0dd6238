/// The worker as a process of a pool: asks a scheduler for stages until told to leave.
#pragma once
#include <string>

namespace regolab {

struct ServeOptions {
  std::string server;  ///< "unix:/path" or "host:port"
  int threads = 1;     ///< inside one stage
  double checkpoint_every_s = 60;
  bool exit_with_parent = false;  ///< die when the starting process dies (embedded mode)
};

/// Returns the process's exit code.
int serve(const ServeOptions& options);

}  // namespace regolab
