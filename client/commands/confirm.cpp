/// `gap confirm`: how far the gap shrinks, by new DEM runs.
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "client/commands/commands.h"
#include "client/commands/gap.h"
#include "client/commands/work.h"
#include "client/design_source.h"
#include "client/file_write.h"
#include "client/number_text.h"
#include "client/views/gap_text.h"
#include "input/number_text.h"
#include "input/unit_convert.h"

namespace regolab::client {
namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned kFirstRound = 4;           // draws: the fewest that tell, and what the time of the others is known by
constexpr const char* kUsualBudget = "1h";
constexpr double kUsualStageCoreS = 5;        // [core-s] of a stage of 300 clusters, before any was timed here

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Outcome read_budget(const std::string& text, double& seconds) {
  const auto number = leading_number(text);
  const auto read = number && !number->rest.empty() ? convert_to_si(number->value, text, number->rest, "s", "a time") : Result<double>(invalid(""));
  if (!read.ok() || !(*read > 0)) return failed(Exit::kUsage, "--budget " + text + " (a time with its unit is wanted) write e.g. --budget 1h or --budget 20min");
  seconds = *read;
  return done();
}

unsigned cores_of(const Arguments& arguments) { return arguments.workers > 0 ? arguments.workers : std::max(1U, std::thread::hardware_concurrency()); }

/// One round of draws, planned, handed in and followed to its end. Failed stages are an answer.
struct Rounds {
  const Arguments& arguments;
  Session& session;
  Console& console;
  std::string diagnosis;
  unsigned first = 0;
  std::vector<unsigned> done_draws = {};
  double fresh_s_per_draw = 0;  ///< measured in rounds that had anything to run

  Outcome plan(unsigned draws, pb::PlanReply& reply) const {
    pb::PlanRequest request;
    request.set_diagnosis(diagnosis), request.set_first(first), request.set_draws(draws);
    auto got = session.lab->plan_confirmation(request, reply);
    return got.ok() ? got : session.explain(got);
  }

  Outcome run(unsigned draws, const pb::PlanReply& plan) {
    const auto start = Clock::now();
    pb::SubmitReply submitted;
    if (auto in = session.lab->submit(plan.design(), submitted); !in.ok()) return session.explain(in);
    if (!submitted.diagnostics().empty()) return rejected(from_proto(submitted.diagnostics()), arguments, console);
    FollowOptions options{.timeout_s = arguments.timeout_s, .verbose = arguments.verbose};
    pb::ExperimentStatus last;
    const Outcome worked = work(arguments, submitted.experiment(), session, options, console, last);
    if (worked.exit == Exit::kInterrupted) return leave_interrupted(arguments, "regolab" + arguments.original_line, session, console);
    if (!worked.ok() && worked.exit != Exit::kTrialsFailed) return worked;
    if (plan.dem_jobs() > 0) fresh_s_per_draw = seconds_since(start) / draws;
    first += draws;
    done_draws.push_back(draws);
    return done();
  }
};

void say_plan(const pb::PlanReply& plan, unsigned draws, double scale, const Arguments& arguments, Console& console) {
  const unsigned cores = cores_of(arguments);
  if (plan.dem_jobs() == 0) {
    console.err << "every run is stored already\n";
    return;
  }
  const bool timed = plan.core_s() >= 0;
  const double seconds = scale * (timed ? plan.core_s() : kUsualStageCoreS * plan.dem_jobs()) / cores;
  console.err << fmt::format("{:.0f} DEM runs for {} draws of each model, about {} on {} {}{}\n", scale * plan.dem_jobs(), draws, duration_text(seconds), cores, cores == 1 ? "core" : "cores",
                             timed ? "" : " (nothing was timed here yet; the first draws will tell)");
}

/// As many of the wanted draws as fit: four first, then what their time leaves room for.
Outcome run_draws(Rounds& rounds, double budget_s) {
  const Arguments& arguments = rounds.arguments;
  const auto start = Clock::now();
  pb::PlanReply plan;
  if (auto got = rounds.plan(kFirstRound, plan); !got.ok()) return got;
  say_plan(plan, arguments.draws, static_cast<double>(arguments.draws) / kFirstRound, arguments, rounds.console);
  if (auto ran = rounds.run(kFirstRound, plan); !ran.ok()) return ran;
  unsigned more = arguments.draws - kFirstRound;
  if (more == 0) return done();
  if (auto got = rounds.plan(more, plan); !got.ok()) return got;
  const double left = budget_s - seconds_since(start);
  if (plan.dem_jobs() > 0) {
    const double each = rounds.fresh_s_per_draw > 0 ? rounds.fresh_s_per_draw : std::max(0.0, plan.core_s()) / cores_of(arguments) / more;
    const auto room = each > 0 ? static_cast<unsigned>(std::clamp(left / each, 0.0, static_cast<double>(more))) : more;
    if (room < more) rounds.console.err << fmt::format("{} draws instead of {}: a draw takes {}, and --budget is {}\n", kFirstRound + room, arguments.draws, duration_text(each), arguments.time_budget);
    more = room;
  }
  if (more == 0) return done();
  if (auto got = rounds.plan(more, plan); !got.ok()) return got;
  return rounds.run(more, plan);
}

/// Why there is nothing to run, or empty.
std::string nothing_to_run(const pb::Diagnosis& d) {
  if (d.verdict() == "NO GAP") return "no gap: the re-calibrated base model measures what was measured, there is nothing to shrink";
  if (d.verdict() == "CANNOT TELL") return "cannot tell which effect is missing: there is nothing to add, so nothing to confirm";
  return "";
}

Outcome show(const Arguments& arguments, const pb::Diagnosis& d, Session& session, Console& console) {
  if (!arguments.output.empty()) {
    if (auto written = write_report(d.id(), arguments.output, session); !written.ok()) return written;
  }
  const std::string nothing = nothing_to_run(d);
  if (arguments.json) {
    Json out = document("gap-confirm");
    add_diagnosis(d, out);
    if (!nothing.empty()) out["nothing_to_confirm"] = nothing;
    console.out << text_of(out) << std::flush;
    return done();
  }
  console.out << (nothing.empty() ? shrinkage_text(d) : fmt::format("{}\nfitted without {}\n", nothing, fmt::join(d.held_out().begin(), d.held_out().end(), ", "))) << std::flush;
  return done();
}

}  // namespace

Outcome confirm_by_runs(const Arguments& arguments, pb::DiagnoseRequest request, Session& session, Console& console, pb::Diagnosis& d) {
  double budget_s = 0;
  if (auto read = read_budget(arguments.time_budget.empty() ? kUsualBudget : arguments.time_budget, budget_s); !read.ok()) return read;
  request.set_hold_out(true);
  if (auto found = run_diagnosis(arguments, request, session, console, d); !found.ok()) return found;
  console.err << fmt::format("fitted without {}: {}{}\n", fmt::join(d.held_out().begin(), d.held_out().end(), ", "), d.verdict(), d.repaired().empty() ? "" : ", repaired by " + d.repaired());
  const bool known = d.has_shrinkage() && d.shrinkage().draws() >= arguments.draws;
  if (known || !nothing_to_run(d).empty()) return done();
  Rounds rounds{arguments, session, console, d.id()};
  if (auto ran = run_draws(rounds, budget_s); !ran.ok()) return ran;
  pb::ShrinkageRequest measure;
  *measure.mutable_of() = request;
  for (const unsigned draws : rounds.done_draws) measure.add_rounds(draws);
  pb::StoredDiagnosis stored;
  if (auto got = session.lab->measure_shrinkage(measure, stored); !got.ok()) return session.explain(got);
  d = stored.diagnosis();
  return done();
}

Outcome gap_confirm(const Arguments& arguments, Console& console) {
  pb::DiagnoseRequest request;
  Session session;
  if (auto opened = open_question(arguments, console, request, session); !opened.ok()) return opened;
  pb::Diagnosis d;
  const Outcome confirmed = confirm_by_runs(arguments, request, session, console, d);
  return confirmed.ok() ? show(arguments, d, session, console) : confirmed;
}

}  // namespace regolab::client
