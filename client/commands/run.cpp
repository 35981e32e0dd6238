#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/commands/work.h"
#include "client/design_source.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/range_text.h"
#include "client/views/study_text.h"

namespace regolab::client {
namespace {

constexpr int kFailuresShown = 10;

/// Opens the session and has the design judged. A database is made only for a design that can run.
Outcome open_for(const Arguments& arguments, const pb::SubmitRequest& request, Session& session, pb::SubmitReply& judged) {
  if (auto opened = open_session(arguments, Need::kStoredOrScratch, session); !opened.ok()) return opened;
  if (auto checked = session.lab->validate(request, judged); !checked.ok()) return session.explain(checked);
  const bool go_on = judged.diagnostics().empty() && !arguments.dry_run;
  if (!go_on || !session.scratch) return done();
  return open_session(arguments, Need::kCreate, session);
}

/// Hands the study in; one that was cancelled before is taken up again.
Outcome hand_in(const Arguments& arguments, const pb::SubmitRequest& request, Session& session, Console& console,
                pb::SubmitReply& reply) {
  if (auto submitted = session.lab->submit(request, reply); !submitted.ok()) return session.explain(submitted);
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  if (!reply.already_known()) return done();
  pb::ExperimentStatus known;
  if (auto got = session.lab->get(reply.experiment(), known); !got.ok()) return session.explain(got);
  console.err << fmt::format("experiment {} is known already ({})\n", reply.experiment(), known.state());
  if (known.state() != "cancelled") return done();
  console.err << "it was cancelled; taking it up again\n";
  return session.explain(session.lab->retry(reply.experiment(), known));
}

/// A design whose points all have levels of their own is there to be learned from, not to be ranged over.
void say_where_and_next(const Arguments& arguments, const pb::ExperimentStatus& status, bool ranged, Console& console) {
  const std::string where = arguments.server.empty() ? arguments.database : arguments.server;
  console.err << fmt::format("\nresults are in {}, experiment {}\n", where, status.experiment());
  if (ranged)
    hint(arguments, console, "range last --response repose_angle");
  else if (status.summary().error_degrees_of_freedom() < 0)
    hint(arguments, console, "train " + status.experiment());
  hint(arguments, console, "results " + status.experiment() + " --csv -o " + status.name() + ".csv");
  if (status.name().find("article") != std::string::npos) hint(arguments, console, "article compare last");
  if (status.jobs().failed() + status.jobs().quarantined() > 0) hint(arguments, console, "retry last");
}

Outcome finish(const Arguments& arguments, Session& session, const pb::ExperimentStatus& status, Console& console) {
  pb::RangeRequest request;
  request.set_experiment(status.experiment());
  pb::RangeReply range;
  const Outcome analysed = session.lab->range(request, range);
  // Too few numbers to analyse is no failure of the verb: the reason is said, and the exit code tells of the trials.
  if (!analysed.ok() && analysed.exit != Exit::kInvalidInput) return session.explain(analysed);
  if (arguments.json) {
    Json out = document("run");
    out["experiment"] = status.experiment();
    out["database"] = arguments.server.empty() ? Json(arguments.database) : Json();
    out["status"] = json_of(status);
    out["range"] = json_of(range);
    console.out << text_of(out);
    return verdict_of(status);
  }
  if (!analysed.ok())
    console.err << "no range analysis: " << analysed.text << "\n";
  else
    console.out << range_matrix_text(range);
  console.out.flush();
  for (int i = 0; i < std::min(status.failures_size(), kFailuresShown); ++i)
    console.err << "  " << status.failures(i) << "\n";
  if (status.failures_size() > kFailuresShown)
    console.err << "  and more: regolab status last" << where_flags(arguments) << "\n";
  say_where_and_next(arguments, status, analysed.ok(), console);
  return verdict_of(status);
}

/// The design read, a session opened for it and the scheduler's approval in `reply`; not ok when anything was refused.
Outcome read_and_open(const Arguments& arguments, Console& console, pb::SubmitRequest& request, Session& session,
                      pb::SubmitReply& reply) {
  std::vector<Diagnostic> diagnostics;
  if (auto read = read_design_source(arguments, request, diagnostics); !read.ok()) {
    return diagnostics.empty() ? read : rejected(diagnostics, arguments, console);
  }
  if (auto opened = open_for(arguments, request, session, reply); !opened.ok()) return opened;
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  return done();
}

}  // namespace

Outcome run_study(const Arguments& arguments, Console& console) {
  if (arguments.dry_run) return show_design(arguments, console);
  pb::SubmitRequest request;
  Session session;
  pb::SubmitReply reply;
  if (auto ready = read_and_open(arguments, console, request, session, reply); !ready.ok()) return ready;
  console.err << summary_text(reply.summary()) << std::endl;
  if (auto in = hand_in(arguments, request, session, console, reply); !in.ok()) return in;

  FollowOptions options{.timeout_s = arguments.timeout_s, .verbose = arguments.verbose};
  pb::ExperimentStatus last;
  const Outcome worked = work(arguments, reply.experiment(), session, options, console, last);
  if (worked.exit == Exit::kInterrupted && session.embedded) {
    return leave_interrupted(arguments, "regolab" + arguments.original_line, session, console);
  }
  if (worked.exit == Exit::kInterrupted) {
    return leave_interrupted(arguments, "regolab watch " + reply.experiment() + where_flags(arguments), session, console);
  }
  return worked.ok() ? finish(arguments, session, last, console) : worked;
}

Outcome submit(const Arguments& arguments, Console& console) {
  pb::SubmitRequest request;
  Session session;
  pb::SubmitReply reply;
  if (auto ready = read_and_open(arguments, console, request, session, reply); !ready.ok()) return ready;
  if (auto in = hand_in(arguments, request, session, console, reply); !in.ok()) return in;
  if (arguments.json) {
    Json out = document("submit");
    out["experiment"] = reply.experiment();
    out["already_known"] = reply.already_known();
    out["summary"] = json_of(reply.summary());
    console.out << text_of(out);
    return done();
  }
  console.err << summary_text(reply.summary());
  console.out << reply.experiment() << "\n" << std::flush;
  hint(arguments, console, "watch " + reply.experiment());
  return done();
}

}  // namespace regolab::client
