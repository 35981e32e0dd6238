#include "client/commands/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace regolab::client {
namespace {

using namespace std::chrono_literals;

constexpr auto kOwnerBackWithin = 2s;  // another client's scheduler that was killed is back by then, or it has ended

unsigned worker_count(const Arguments& arguments) {
  return arguments.workers > 0 ? arguments.workers : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

Outcome work(const Arguments& arguments, const std::string& experiment, Session& session, FollowOptions& options,
             Console& console, pb::ExperimentStatus& last) {
  while (true) {
    const bool borrowed = arguments.server.empty() && !session.embedded;
    if (borrowed) {
      console.err << fmt::format("another regolab works on {}; following its scheduler\n", arguments.database);
      options.patience = kOwnerBackWithin;
    }
    if (auto got = session.lab->get(experiment, last); !got.ok()) return session.explain(got);
    if (has_ended(last)) return done();
    if (session.embedded) session.embedded->have_workers(worker_count(arguments));
    const Outcome outcome = session.explain(follow(*session.lab, experiment, options, console, last));
    if (!borrowed || outcome.exit != Exit::kUnreachable) return outcome;
    console.err << "the other regolab has ended; going on without it\n";
    if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  }
}

Outcome leave_interrupted(const Arguments& arguments, const std::string& again, Session& session, Console& console) {
  if (!session.embedded) {
    return failed(Exit::kInterrupted,
                  fmt::format("stopped watching (the experiment goes on) watch it again with `{}`", again));
  }
  console.err << "stopping; the workers save where they are (Ctrl-C again: stop at once)" << std::endl;
  session.lab.reset();
  session.embedded.reset();
  return failed(Exit::kInterrupted,
                fmt::format("interrupted (what was finished is in {}) go on with `{}`", arguments.database, again));
}

}  // namespace regolab::client
