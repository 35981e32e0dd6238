#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/commands/gap.h"
#include "client/commands/work.h"
#include "client/file_read.h"
#include "client/design_source.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/gap_next.h"
#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

Json strength_json(const pb::EffectStrength& s) {
  return {{"effect", s.effect()}, {"unit", s.unit_si()}, {"median", s.median()}, {"q05", s.low_05()}, {"q95", s.high_95()}};
}

Json optional_json(bool has, double value) { return has ? Json(value) : Json(); }

Json json_of(const pb::FittedFeature& f) {
  Json out{{"id", f.id()}, {"group", f.group()}, {"unit", f.unit()}, {"held_out", f.held_out()}, {"measured", f.measured()}, {"measured_error", f.measured_error()},
           {"base", f.base()}, {"base_error", f.base_error()}, {"repaired", optional_json(f.has_repaired(), f.repaired())},
           {"repaired_error", optional_json(f.has_repaired_error(), f.repaired_error())}};
  if (f.base_runs() > 0) out["base_runs"] = f.base_runs(), out["repaired_runs"] = f.repaired_runs();
  return out;
}

Json json_of(const pb::Shrinkage& s) {
  Json out{{"S", optional_json(s.has_s(), s.s())}, {"q05", optional_json(s.has_q05(), s.q05())}, {"q95", optional_json(s.has_q95(), s.q95())},
           {"heldout", std::vector<std::string>(s.heldout().begin(), s.heldout().end())}, {"emulator_S", optional_json(s.has_emulator_s(), s.emulator_s())},
           {"undefined", s.undefined().empty() ? Json() : Json(s.undefined())}, {"model", s.model()}, {"base_gap", s.base_gap()}, {"base_gap_noise_95", s.base_gap_noise_95()},
           {"repaired_gap", optional_json(s.has_repaired_gap(), s.repaired_gap())}, {"draws", s.draws()}, {"diagnosis", s.diagnosis()},
           {"experiments", std::vector<std::string>(s.experiments().begin(), s.experiments().end())}, {"features", Json::array()},
           {"warnings", std::vector<std::string>(s.warnings().begin(), s.warnings().end())}};
  for (const auto& f : s.features()) out["features"].push_back(json_of(f));
  return out;
}

}  // namespace

void add_diagnosis(const pb::Diagnosis& d, Json& out) {
  out["case"] = d.case_name();
  out["verdict"] = d.verdict();
  out["classes"] = std::vector<std::string>(d.classes().begin(), d.classes().end());
  out["p"] = Json::array(), out["strength"] = Json::array(), out["where"] = Json::array(), out["isolability"] = Json::array();
  for (const auto& m : d.models()) {
    out["p"].push_back({{"model", m.cause()}, {"effect", m.model()}, {"prob", m.probability()}, {"logZ", m.log_z()}, {"logZ_err", m.log_z_error()}});
  }
  for (const auto& m : d.models()) {
    for (const auto& s : m.strength()) out["strength"].push_back(strength_json(s));
  }
  for (const auto& g : d.where()) {
    out["where"].push_back({{"group", g.group()}, {"feature", g.feature()}, {"text", g.text()}, {"shift_pct", g.shift_pct()}, {"z", g.z()}, {"p", g.p()}, {"p_adj", g.p_adjusted()}});
  }
  for (const auto& i : d.isolability()) out["isolability"].push_back({{"effect", i.effect()}, {"sigma", i.sigma()}, {"twin", i.twin()}, {"cosine", i.cosine()}});
  out["adequacy"] = {{"p", d.adequacy_p()}, {"threshold", d.adequacy_threshold()}};
  out["shrinkage"] = d.has_shrinkage() ? json_of(d.shrinkage()) : Json();
  out["held_out"] = std::vector<std::string>(d.held_out().begin(), d.held_out().end());
  out["repaired"] = d.repaired().empty() ? Json() : Json(d.repaired());
  out["fits"] = Json::array();
  for (const auto& f : d.fits()) out["fits"].push_back(json_of(f));
  out["next_tests"] = next_json(d);
  out["warnings"] = std::vector<std::string>(d.warnings().begin(), d.warnings().end());
  out["provenance"] = {{"bank", d.bank()}, {"features", d.features()}, {"seed", d.seed()}, {"physics_version", d.physics_version()},
                       {"diagnosis", d.id()}, {"kernels", d.kernels()}, {"method", d.method()}};
}

Outcome read_bank_files(const Arguments& arguments, pb::DiagnoseRequest& request) {
  std::string text;
  if (!arguments.bank.empty()) {
    if (auto read = read_whole_file(arguments.bank, kLargestBank, "a bank", text); !read.ok()) return read;
    request.set_bank_csv(text), request.set_bank_name(arguments.bank);
  }
  if (!arguments.kernels.empty()) {
    if (auto read = read_whole_file(arguments.kernels, kLargestBank, "a file of kernels", text); !read.ok()) return read;
    request.set_kernels_json(text);
  }
  return done();
}

Outcome gap_emulate(const Arguments& arguments, Console& console) {
  std::string text;
  if (auto read = read_whole_file(arguments.bank, kLargestBank, "a bank", text); !read.ok()) return read;
  pb::EmulateRequest request;
  request.set_bank_csv(text), request.set_file_name(arguments.bank);
  Session session;
  if (auto opened = open_session(arguments, Need::kScratch, session); !opened.ok()) return opened;
  pb::EmulateReply reply;
  if (auto got = session.lab->emulate(request, reply); !got.ok()) return session.explain(got);
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  if (!arguments.output.empty()) return write_file(arguments.output, reply.kernels_json());
  console.out << reply.kernels_json() << std::flush;
  return done();
}

Outcome open_question(const Arguments& arguments, Console& console, pb::DiagnoseRequest& request, Session& session) {
  if (auto read = read_measurements(arguments, *request.mutable_measurements()); !read.ok()) return read;
  if (auto read = read_bank_files(arguments, request); !read.ok()) return read;
  request.mutable_measurements()->set_want_file(false);  // --report is another file
  request.set_seed(arguments.random_seed);
  if (auto opened = open_session(arguments, Need::kStoredOrScratch, session); !opened.ok()) return opened;
  pb::ImportReply judged;
  if (auto got = session.lab->import_observations(request.measurements(), judged); !got.ok()) return session.explain(got);
  if (!judged.diagnostics().empty()) return rejected(from_proto(judged.diagnostics()), arguments, console);
  return session.scratch ? open_session(arguments, Need::kCreate, session) : done();
}

Outcome run_diagnosis(const Arguments& arguments, const pb::DiagnoseRequest& request, Session& session, Console& console, pb::Diagnosis& diagnosis) {
  const auto start = std::chrono::steady_clock::now();
  const auto show = [&](const pb::DiagnoseEvent& event) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string left = event.done() < 2 ? "" : fmt::format(", about {:.0f} s left", spent / event.done() * (event.of() - event.done()));
    console.err << fmt::format("{}/{}: {}{}\n", event.done() + 1, event.of(), event.what(), left) << std::flush;
  };
  pb::DiagnoseEvent last;
  if (auto got = session.lab->diagnose(request, show, last); !got.ok()) {
    if (got.exit == Exit::kInterrupted) return leave_interrupted(arguments, "regolab" + arguments.original_line, session, console);
    return session.explain(got);
  }
  if (!last.diagnostics().empty()) return rejected(from_proto(last.diagnostics()), arguments, console);
  if (last.stored()) console.err << fmt::format("diagnosis {} is known already\n", last.diagnosis().id().substr(0, 12)) << std::flush;
  diagnosis = last.diagnosis();
  for (const std::string& warning : diagnosis.warnings()) console.err << paint(console.colour_err, Ink::kYellow, "warning: ") << warning << "\n";
  console.err << std::flush;
  return done();
}

std::string question_words(const Arguments& arguments) {
  std::string words = arguments.observations;
  const auto add = [&](const char* option, const std::string& value) { words += value.empty() ? "" : std::string(" ") + option + " " + value; };
  add("--map", arguments.map), add("--bank", arguments.bank), add("--kernels", arguments.kernels);
  if (arguments.assume_errors) words += " --assume-errors";
  return words;
}

Outcome gap_diagnose(const Arguments& arguments, Console& console) {
  pb::DiagnoseRequest request;
  Session session;
  if (auto opened = open_question(arguments, console, request, session); !opened.ok()) return opened;
  pb::Diagnosis diagnosis;
  if (auto found = run_diagnosis(arguments, request, session, console, diagnosis); !found.ok()) return found;
  std::string reported = diagnosis.id();
  if (!arguments.time_budget.empty()) {
    pb::Diagnosis held_out;
    if (auto confirmed = confirm_by_runs(arguments, request, session, console, held_out); !confirmed.ok()) return confirmed;
    if (held_out.has_shrinkage()) *diagnosis.mutable_shrinkage() = held_out.shrinkage(), reported = held_out.id();
  }
  if (!arguments.output.empty()) {
    if (auto written = write_report(reported, arguments.output, session); !written.ok()) return written;
  }
  if (arguments.json) {
    Json out = document("gap-diagnose");
    add_diagnosis(diagnosis, out);
    console.out << text_of(out) << std::flush;
    return done();
  }
  console.out << diagnosis_text(diagnosis) << std::flush;
  if (!diagnosis.has_shrinkage() && !diagnosis.repaired().empty()) hint(arguments, console, "gap confirm " + question_words(arguments));
  return done();
}

Outcome gap_next(const Arguments& arguments, Console& console) {
  pb::DiagnoseRequest request;
  Session session;
  if (auto opened = open_question(arguments, console, request, session); !opened.ok()) return opened;
  pb::Diagnosis d;
  if (auto found = run_diagnosis(arguments, request, session, console, d); !found.ok()) return found;
  if (arguments.json) {
    Json out = document("gap-next");
    out["case"] = d.case_name();
    out["verdict"] = d.verdict();
    out["open_nats"] = d.open_nats();
    out["next_tests"] = next_json(d);
    console.out << text_of(out);
  } else {
    console.out << diagnosis_lines(d)[1] << "\n" << next_text(d);
  }
  console.out << std::flush;
  return done();
}

}  // namespace regolab::client
