/// Following an experiment with workers of our own where the scheduler is ours: what `run` and `watch` share.
#pragma once
#include <string>

#include "client/arguments.h"
#include "client/console.h"
#include "client/follow.h"
#include "client/outcome.h"
#include "client/session.h"

namespace regolab::client {

/// Until the experiment has ended. When another regolab that served this database ends meanwhile, goes on with a scheduler
/// of our own.
Outcome work(const Arguments& arguments, const std::string& experiment, Session& session, FollowOptions& options,
             Console& console, pb::ExperimentStatus& last);

/// Ends our workers and scheduler, and says how to go on. `again` is the command line for it.
Outcome leave_interrupted(const Arguments& arguments, const std::string& again, Session& session, Console& console);

}  // namespace regolab::client
