/// serve() for any function that runs stages: the real DEM, or a test's stand-in.
#pragma once
#include "worker/rpc/serve.h"
#include "worker/rpc/stage_thread.h"

namespace regolab {

/// SIGTERM and SIGINT: checkpoint, hand the job back, return 0. REQUIRES: called before other threads are started.
int serve_with(const ServeOptions& options, StageFunction run);

}  // namespace regolab
