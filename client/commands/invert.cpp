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

constexpr unsigned kSeeds = 4;          // of a round
constexpr std::size_t kFinalists = 1;   // a round: beds are spent on one material until they tell
constexpr unsigned kProposals = 8;      // asked for, as some have been run

struct Confirmation {
  std::vector<Confirmed> tried;
  const Confirmed* best = nullptr;
  unsigned runs = 0;
  bool met() const { return best && best->met(); }
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
  request.set_candidates(std::max<unsigned>(arguments.candidates, arguments.confirm ? kProposals : 1));
  return done();
}

/// Hands in candidates, waits for them, and reads what they measured. A stage without numbers is an answer.
Outcome run_round(const Arguments& arguments, const pb::InvertReply& reply, const std::vector<pb::Candidate>& candidates, RoundSeeds seeds, Session& session,
                  Console& console, std::string& experiment, std::vector<Confirmed>& tried) {
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
  learn(reply, candidates, experiment, results, tried);
  return done();
}

std::string confirmed_text(const pb::InvertReply& reply, const Confirmed& c) {
  std::string text = material_text(c.candidate.set(), reply) + "\n";
  for (int t = 0; t < reply.targets_size(); ++t) {
    const auto& target = reply.targets(t);
    const MeasuredTarget& m = c.targets[static_cast<std::size_t>(t)];
    const char* verdict = m.met() ? "met" : c.open() ? "open, more runs must tell" : "missed";
    text += fmt::format("  {:<28} DEM {:.4g}{} {} ({} seed{}), wanted {:.4g} ± {:.2g}: {}\n", target.response(), m.mean(),
                        m.runs.size() < 2 ? "" : fmt::format(" ± {:.2g}", m.standard_error()), target.unit() == "1" ? "" : target.unit(), m.runs.size(),
                        m.runs.size() == 1 ? "" : "s", target.value(), target.tolerance(), verdict);
  }
  return text;
}

/// The most probable material with several seeds, and again while it may still fit; else the next, by what was learned. Until the
/// mean of one meets every target and is known as well as the tolerance asks, or the budget is spent.
Outcome confirm(const Arguments& arguments, pb::InvertRequest request, pb::InvertReply& reply, Session& session, Console& console, Confirmation& out) {
  RoundSeeds seeds;
  while (!out.met()) {
    const auto candidates = next_round(out.tried, reply, kFinalists);
    if (candidates.empty()) break;
    const unsigned per_seed = runs_of_one(reply) * static_cast<unsigned>(candidates.size());
    seeds.count = std::min(arguments.seeds == 0 ? kSeeds : arguments.seeds, (arguments.budget - out.runs) / per_seed);
    if (seeds.count == 0) break;
    console.err << fmt::format("confirming: {} material{} x {} seed{}, {} DEM runs ({} of {} spent)\n", candidates.size(), candidates.size() == 1 ? "" : "s",
                               seeds.count, seeds.count == 1 ? "" : "s", seeds.count * per_seed, out.runs, arguments.budget);
    std::string experiment;
    if (auto ran = run_round(arguments, reply, candidates, seeds, session, console, experiment, out.tried); !ran.ok()) return ran;
    out.runs += seeds.count * per_seed;
    seeds.first += seeds.count;
    for (const Confirmed& one : out.tried) {
      if (one.experiments.back() == experiment) console.err << confirmed_text(reply, one);
    }
    out.best = best_of(out.tried);
    request.add_experiments(experiment);
    if (out.met()) break;
    if (auto again = session.lab->invert(request, reply); !again.ok()) return session.explain(again);
  }
  return done();
}

Json json_of(const pb::InvertReply& reply, const Confirmed& c) {
  Json out{{"set", std::map<std::string, std::string>(c.candidate.set().begin(), c.candidate.set().end())}, {"experiments", c.experiments}, {"met", c.met()}, {"measured", Json::array()}};
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(); };
  for (int t = 0; t < reply.targets_size(); ++t) {
    const MeasuredTarget& m = c.targets[static_cast<std::size_t>(t)];
    out["measured"].push_back({{"response", reply.targets(t).response()}, {"unit", reply.targets(t).unit()}, {"runs", m.runs}, {"mean", number(m.mean())},
                               {"standard_error", number(m.standard_error())}});
  }
  out["largest_miss_in_tolerances"] = number(c.miss());
  return out;
}

void show(const Arguments& arguments, const pb::InvertReply& reply, const Confirmation& confirmation, Console& console) {
  if (arguments.json) {
    Json out = document("invert");
    add_inversion(reply, out);
    if (arguments.confirm) {
      out["confirmed"] = {{"met", confirmation.met()}, {"dem_runs", confirmation.runs}, {"tried", Json::array()}};
      for (const Confirmed& one : confirmation.tried) out["confirmed"]["tried"].push_back(json_of(reply, one));
      out["confirmed"]["best"] = confirmation.best ? json_of(reply, *confirmation.best) : Json();
    }
    console.out << text_of(out);
    return;
  }
  console.out << inversion_text(reply);
  if (!arguments.confirm) return;
  console.out << fmt::format("\n{} by DEM with {} runs\n", confirmation.met() ? "confirmed" : "NOT confirmed", confirmation.runs);
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
  return confirmation.met() ? done() : failed(Exit::kTrialsFailed, fmt::format("no material met the targets within {} DEM runs (see the nearest above; runs of one material scatter, too) widen a tolerance, or raise --budget or --seeds", confirmation.runs));
}

}  // namespace regolab::client
