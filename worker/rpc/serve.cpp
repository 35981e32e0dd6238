#include "worker/rpc/serve.h"

#include "worker/rpc/pool_worker.h"
#include "worker/stage/run_stage.h"

namespace regolab {

int serve(const ServeOptions& options) { return serve_with(options, run_stage); }

}  // namespace regolab
