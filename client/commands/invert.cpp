#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "client/commands/commands.h"
#include "client/commands/work.h"
#include "client/confirm.h"
#include "client/design_source.h"
#include "client/session.h"
#include "client/surrogate_json.h"
#include "client/views/surrogate_text.h"

namespace regolab::client {
namespace {

constexpr unsigned kSeeds = 4;  // of a confirmation
constexpr int kFinalists = 2;   // run side by side: a design varies something

struct Confirmation {
  std::vector<Confirmed> rounds;  ///< every candidate run, in order
  const Confirmed* best = nullptr;
  bool met = false;
  unsigned runs = 0;
};

Outcome read_target(const Arguments& arguments, pb::InvertRequest& request) {
  std::ifstream in(arguments.target, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    return failed(Exit::kInvalidInput, arguments.target + " cannot be read (no such file, empty, or no permission) correct the name");
  }
  request.set_model(arguments.model);
  request.set_file_name(arguments.target);
  request.set_target_yaml(text.str());
  request.set_candidates(std::max<unsigned>(arguments.candidates, arguments.confirm ? kFinalists : 1));
  return done();
}

/// Hands in candidates, waits for them, and reads what they measured. A stage without numbers is an answer.
Outcome run_round(const Arguments& arguments, const pb::InvertReply& reply, int candidates, unsigned seeds, Session& session, Console& console,
                  std::string& experiment, std::vector<Confirmed>& out) {
  pb::SubmitReply submitted;
  const auto design = confirmation_design(reply, candidates, seeds, "invert");
  if (auto in = session.lab->submit(design, submitted); !in.ok()) return session.explain(in);
  if (!submitted.diagnostics().empty()) return rejected(from_proto(submitted.diagnostics()), arguments, console);
  experiment = submitted.experiment();
  FollowOptions options{.timeout_s = arguments.timeout_s, .verbose = arguments.verbose};
  pb::ExperimentStatus last;
  if (auto worked = work(arguments, experiment, session, options, console, last); !worked.ok()) return worked;
  pb::ResultsReply results;
  if (auto got = session.lab->results(experiment, results); !got.ok()) return session.explain(got);
  out = confirmed_of(reply, candidates, experiment, results);
  return done();
}

std::string confirmed_text(const pb::InvertReply& reply, const Confirmed& c) {
  std::string text = material_text(c.candidate.set(), reply) + "\n";
  for (int t = 0; t < reply.targets_size(); ++t) {
    const auto k = static_cast<std::size_t>(t);
    const auto& target = reply.targets(t);
    text += fmt::format("  {:<28} DEM {:.4g}{} {} ({} seeds), wanted {:.4g} ± {:.2g}: {}\n", target.response(), c.mean[k],
                        std::isnan(c.standard_error[k]) ? "" : fmt::format(" ± {:.2g}", c.standard_error[k]), target.unit() == "1" ? "" : target.unit(), c.seeds, target.value(),
                        target.tolerance(), std::abs(c.mean[k] - target.value()) <= target.tolerance() ? "met" : "missed");
  }
  return text;
}

/// The two most probable with several seeds, learned from, and the next two, until one meets every target on average or the budget
/// is spent; the last round has as many seeds as are left.
Outcome confirm(const Arguments& arguments, pb::InvertRequest request, pb::InvertReply& reply, Session& session, Console& console, Confirmation& out) {
  const int candidates = std::min(kFinalists, reply.candidates_size());
  const unsigned per_seed = runs_of_one(reply) * static_cast<unsigned>(candidates);
  while (!out.met) {
    const unsigned seeds = std::min(arguments.seeds == 0 ? kSeeds : arguments.seeds, (arguments.budget - out.runs) / per_seed);
    if (seeds < std::min(2u, arguments.seeds == 0 ? kSeeds : arguments.seeds)) break;
    console.err << fmt::format("confirming: {} materials x {} seed{}, {} DEM runs ({} of {} spent)\n", candidates, seeds, seeds == 1 ? "" : "s", seeds * per_seed,
                               out.runs, arguments.budget);
    std::string experiment;
    std::vector<Confirmed> round;
    if (auto ran = run_round(arguments, reply, candidates, seeds, session, console, experiment, round); !ran.ok()) return ran;
    out.runs += seeds * per_seed;
    for (const Confirmed& one : round) console.err << confirmed_text(reply, one);
    out.rounds.insert(out.rounds.end(), round.begin(), round.end());
    out.met = std::ranges::any_of(round, [](const Confirmed& c) { return c.miss <= 1; });
    request.add_experiments(experiment);
    if (out.met) break;
    if (auto again = session.lab->invert(request, reply); !again.ok()) return session.explain(again);
  }
  for (const Confirmed& one : out.rounds) {
    if (!out.best || one.miss < out.best->miss) out.best = &one;
  }
  return done();
}

Json json_of(const pb::InvertReply& reply, const Confirmed& c) {
  Json out{{"set", std::map<std::string, std::string>(c.candidate.set().begin(), c.candidate.set().end())},
           {"experiment", c.experiment}, {"point", c.point}, {"seeds", c.seeds}, {"measured", Json::array()}};
  for (int t = 0; t < reply.targets_size(); ++t) {
    const auto k = static_cast<std::size_t>(t);
    const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(); };
    out["measured"].push_back({{"response", reply.targets(t).response()}, {"unit", reply.targets(t).unit()}, {"mean", number(c.mean[k])},
                               {"standard_error", number(c.standard_error[k])}});
  }
  out["largest_miss_in_tolerances"] = std::isfinite(c.miss) ? Json(c.miss) : Json();
  return out;
}

void show(const Arguments& arguments, const pb::InvertReply& reply, const Confirmation& confirmation, Console& console) {
  if (arguments.json) {
    Json out = document("invert");
    add_inversion(reply, out);
    if (arguments.confirm) {
      out["confirmed"] = {{"met", confirmation.met}, {"dem_runs", confirmation.runs}, {"tried", Json::array()}};
      for (const Confirmed& one : confirmation.rounds) out["confirmed"]["tried"].push_back(json_of(reply, one));
      out["confirmed"]["best"] = confirmation.best ? json_of(reply, *confirmation.best) : Json();
    }
    console.out << text_of(out);
    return;
  }
  console.out << inversion_text(reply);
  if (!arguments.confirm) return;
  console.out << fmt::format("\n{} by DEM with {} runs\n", confirmation.met ? "confirmed" : "NOT confirmed", confirmation.runs);
  if (confirmation.best) console.out << confirmed_text(reply, *confirmation.best);
}

}  // namespace

Outcome invert(const Arguments& arguments, Console& console) {
  pb::InvertRequest request;
  if (auto read = read_target(arguments, request); !read.ok()) return read;
  Session session;
  if (auto opened = open_session(arguments, arguments.confirm ? Need::kCreate : Need::kStoredOrScratch, session); !opened.ok()) return opened;
  pb::InvertReply reply;
  if (auto got = session.lab->invert(request, reply); !got.ok()) return session.explain(got);
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  Confirmation confirmation;
  if (arguments.confirm) {
    if (auto ran = confirm(arguments, request, reply, session, console, confirmation); !ran.ok()) return ran;
  }
  show(arguments, reply, confirmation, console);
  console.out.flush();
  if (!arguments.confirm) {
    hint(arguments, console, "invert " + arguments.target + " --confirm");
    return done();
  }
  return confirmation.met ? done() : failed(Exit::kTrialsFailed, fmt::format("no material met the targets within {} DEM runs (see the nearest above; runs of one material scatter, too) widen a tolerance, or raise --budget or --seeds", confirmation.runs));
}

}  // namespace regolab::client
