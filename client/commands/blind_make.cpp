#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "client/blind/key_file.h"
#include "client/blind/pace.h"
#include "client/blind/sealed_truths.h"
#include "client/commands/commands.h"
#include "client/commands/work.h"
#include "client/design_source.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/session.h"
#include "digest/sha256.h"
#include "seal/random_bytes.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kSecretBytes = 32;

/// A case under way: its truth, and the experiment of each of its designs.
struct BlindCase {
  std::string id;
  pb::BlindTruth truth;
  std::vector<std::string> experiments;
};

/// Where the runs go: not into the database of everyday work, which anybody reads, and not into the set's folder.
Outcome place_runs(Arguments& arguments) {
  if (!arguments.own_database && arguments.server.empty())
    arguments.database = fs::path(default_key_file(arguments.folder)).replace_extension(".db").string();
  if (!arguments.server.empty() || !lies_in(arguments.database, arguments.folder)) return done();
  return failed(Exit::kUsage, fmt::format("--db {} lies in the set's folder (its runs tell every truth) put it elsewhere", arguments.database));
}

Outcome draw_set(const Arguments& arguments, const std::string& key, Session& session, Console& console, BlindFolder& folder) {
  BlindSet set{.cases = arguments.cases, .nulls = arguments.nulls, .specimens = arguments.specimens, .seed = {}};
  pb::BlindDrawRequest request;
  request.set_cases(set.cases), request.set_nulls(set.nulls), request.set_specimens(set.specimens);
  if (arguments.development) {
    set.seed = arguments.random_seed;
    const auto secret = bytes_of_hex(sha256_hex(fmt::format("regolab development set {}", arguments.random_seed)));
    request.set_secret(*secret), request.set_development(true);
  } else {
    const auto secret = random_bytes(kSecretBytes);  // kept nowhere: what it made is under seal
    if (!secret.ok()) return failed(Exit::kInternal, secret.error().text);
    request.set_secret(*secret);
  }
  pb::BlindDrawReply drawn;
  if (auto got = session.lab->draw_blind(request, drawn); !got.ok()) return session.explain(got);
  if (auto sealed = seal_truths(drawn, key, set, folder); !sealed.ok()) return sealed;
  console.err << fmt::format("{} truths drawn and committed to, before any run. {}:\n  {}\n", drawn.truths_size(),
                             set.seed ? "A DEVELOPMENT set, no part of any record" : "Publish this now, it binds you to all of them",
                             folder.list_digest());
  return done();
}

/// A set is made as it was begun.
Outcome same_set(const Arguments& arguments, const BlindSet& set) {
  const Arguments usual;
  const auto differs = [](unsigned asked, unsigned standard, unsigned is) { return asked != standard && asked != is; };
  if (!differs(arguments.cases, usual.cases, set.cases) && !differs(arguments.nulls, usual.nulls, set.nulls) &&
      !differs(arguments.specimens, usual.specimens, set.specimens) && (!arguments.development || set.seed == arguments.random_seed)) {
    return done();
  }
  return failed(
      Exit::kUsage,
      fmt::format("{} holds another set ({} cases, {} extra nulls, {} specimens{}) leave the options out to go on with it, or choose another DIR",
                  arguments.folder, set.cases, set.nulls, set.specimens, set.seed ? fmt::format(", development seed {}", *set.seed) : ""));
}

/// Hands in every design of a case; what is known already is taken as it is.
Outcome hand_in(const Arguments& arguments, Session& session, Console& console, BlindCase& one) {
  pb::BlindDesignReply designs;
  if (auto got = session.lab->design_blind(one.truth, designs); !got.ok()) return session.explain(got);
  for (pb::SubmitRequest design : designs.designs()) {
    design.set_request_id(new_request_id());
    pb::SubmitReply reply;
    if (auto in = session.lab->submit(design, reply); !in.ok()) return session.explain(in);
    if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
    one.experiments.push_back(reply.experiment());
    pb::ExperimentStatus known;
    if (!reply.already_known()) continue;
    if (auto got = session.lab->get(reply.experiment(), known); !got.ok()) return session.explain(got);
    if (known.state() != "cancelled") continue;
    if (auto again = session.lab->retry(reply.experiment(), known); !again.ok()) return session.explain(again);
  }
  return done();
}

/// Waits for a case's runs and writes what was measured. Stages without numbers are data: their quantities are absent.
Outcome measure(const Arguments& arguments, const BlindFolder& folder, Session& session, Console& console, const BlindCase& one, std::string& said) {
  pb::BlindObserveRequest request;
  *request.mutable_truth() = one.truth;
  for (const std::string& experiment : one.experiments) {
    FollowOptions options{.timeout_s = arguments.timeout_s, .verbose = arguments.verbose};
    pb::ExperimentStatus last;
    if (auto worked = work(arguments, experiment, session, options, console, last); !worked.ok()) return worked;
    request.add_experiments(experiment);
  }
  pb::BlindObserveReply reply;
  if (auto got = session.lab->observe_blind(request, reply); !got.ok()) return session.explain(got);
  said = fmt::format("{} stages, {} without numbers", reply.stages(), reply.without_numbers());
  return write_file(folder.case_file(one.id), reply.file());
}

Outcome run_cases(const Arguments& arguments, const BlindFolder& folder, const std::string& key, std::vector<BlindCase> cases, Session& session,
                  Console& console) {
  for (BlindCase& one : cases) {
    const auto commitment = std::ranges::find(folder.commitments(), one.id, &Digest::id);
    std::string text;
    if (auto opened = open_truth(folder, *commitment, key, text); !opened.ok()) return opened;
    one.truth.set_id(one.id), one.truth.set_text(text);
    if (auto in = hand_in(arguments, session, console, one); !in.ok()) return in;
  }
  Pace pace(cases.size());
  for (const BlindCase& one : cases) {
    std::string said;
    const Outcome measured = measure(arguments, folder, session, console, one, said);
    if (measured.exit == Exit::kInterrupted) return leave_interrupted(arguments, "regolab" + arguments.original_line, session, console);
    if (!measured.ok()) return measured;
    pace.one_done();
    console.err << fmt::format("case {}: {}; {}\n", one.id, said, pace.text()) << std::flush;
  }
  return done();
}

std::vector<BlindCase> cases_to_run(const BlindFolder& folder, unsigned only) {
  std::vector<BlindCase> out;
  std::error_code ignored;
  for (const Digest& commitment : folder.commitments()) {
    if (only > 0 && out.size() == only) break;
    if (!fs::exists(folder.case_file(commitment.id), ignored)) out.push_back({commitment.id, {}, {}});
  }
  return out;
}

void say_what_next(const Arguments& arguments, const fs::path& key, const BlindFolder& folder, Console& console) {
  const std::size_t left = cases_to_run(folder, 0).size(), all = folder.commitments().size();
  if (arguments.json) {
    Json out = document("blind-make");
    out["folder"] = arguments.folder, out["key"] = key.string(), out["development"] = folder.set().seed.has_value();
    out["database"] = arguments.server.empty() ? Json(arguments.database) : Json();
    out["cases"] = all, out["measured"] = all - left, out["commitments_sha256"] = folder.list_digest();
    console.out << text_of(out) << std::flush;
    return;
  }
  console.out << fmt::format("{} of {} cases measured in {}{}\n", all - left, all, arguments.folder,
                             folder.set().seed ? " (DEVELOPMENT set, no part of any record)" : "");
  console.out << fmt::format(
      "{} is the key of the truths; {} tells them too. The solver is denied both; keep them from people as well until the reveal.\n", key.string(),
      arguments.server.empty() ? arguments.database : "the database of " + arguments.server);
  console.out << std::flush;
  console.err << fmt::format("next: regolab gap blind {} {}\n", left > 0 ? "make" : "solve", arguments.folder);
}

}  // namespace

Outcome blind_make(const Arguments& given, Console& console) {
  Arguments arguments = given;
  const fs::path key_file = arguments.key.empty() ? default_key_file(arguments.folder) : fs::path(arguments.key);
  if (auto placed = place_runs(arguments); !placed.ok()) return placed;
  if (lies_in(key_file, arguments.folder))
    return failed(Exit::kUsage,
                  fmt::format("--key {} lies in the set's folder (whoever has the cases would have the key) put it elsewhere", key_file.string()));
  BlindFolder folder(arguments.folder);
  if (auto locked = folder.lock(true); !locked.ok()) return locked;
  const bool known = folder.drawn();
  std::string key;
  if (auto got = known ? read_key(key_file, arguments.folder, key) : make_key(key_file, arguments.folder, key); !got.ok()) return got;
  if (known) {
    if (auto got = folder.read(); !got.ok()) return got;
    if (auto same = same_set(arguments, folder.set()); !same.ok()) return same;
    if (cases_to_run(folder, 0).empty()) return say_what_next(arguments, key_file, folder, console), done();
  }
  Session session;
  if (auto opened = open_session(arguments, Need::kCreate, session); !opened.ok()) return opened;
  if (!known) {
    if (auto drawn = draw_set(arguments, key, session, console, folder); !drawn.ok()) return drawn;
  }
  if (auto ran = run_cases(arguments, folder, key, cases_to_run(folder, arguments.only), session, console); !ran.ok()) return ran;
  say_what_next(arguments, key_file, folder, console);
  return done();
}

}  // namespace regolab::client
