#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/commands/gap.h"
#include "client/file_read.h"
#include "client/design_source.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/gap_html.h"
#include "client/views/gap_next.h"
#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

Json strength_json(const pb::EffectStrength& s) {
  return {{"effect", s.effect()}, {"unit", s.unit_si()}, {"median", s.median()}, {"q05", s.low_05()}, {"q95", s.high_95()}};
}

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
  out["shrinkage"] = Json();
  out["next_tests"] = next_json(d);
  out["warnings"] = std::vector<std::string>(d.warnings().begin(), d.warnings().end());
  out["provenance"] = {{"bank", d.bank()}, {"features", d.features()}, {"seed", d.seed()}, {"physics_version", d.physics_version()}};
}

}  // namespace

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

namespace {

/// Diagnoses with progress on stderr. The file may have been refused: see the diagnostics of `last`.
Outcome diagnose(const Arguments& arguments, Console& console, Session& session, pb::DiagnoseRequest& request, pb::DiagnoseEvent& last) {
  if (auto read = read_measurements(arguments, *request.mutable_measurements()); !read.ok()) return read;
  if (auto read = read_bank_files(arguments, request); !read.ok()) return read;
  request.mutable_measurements()->set_want_file(false);  // --report is another file
  request.set_seed(arguments.random_seed);
  if (auto opened = open_session(arguments, Need::kScratch, session); !opened.ok()) return opened;
  const auto start = std::chrono::steady_clock::now();
  const auto show = [&](const pb::DiagnoseEvent& event) {
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string left = event.done() < 2 ? "" : fmt::format(", about {:.0f} s left", spent / event.done() * (event.of() - event.done()));
    console.err << fmt::format("{}/{}: {}{}\n", event.done() + 1, event.of(), event.what(), left) << std::flush;
  };
  if (auto got = session.lab->diagnose(request, show, last); !got.ok()) return session.explain(got);
  return last.diagnostics().empty() ? done() : rejected(from_proto(last.diagnostics()), arguments, console);
}

}  // namespace

Outcome gap_diagnose(const Arguments& arguments, Console& console) {
  Session session;
  pb::DiagnoseRequest request;
  pb::DiagnoseEvent last;
  if (auto got = diagnose(arguments, console, session, request, last); !got.ok()) return got;
  if (!arguments.output.empty()) {
    pb::ImportReply measured;
    if (auto got = session.lab->import_observations(request.measurements(), measured); !got.ok()) return session.explain(got);
    if (auto written = write_file(arguments.output, diagnosis_html(last.diagnosis(), measured)); !written.ok()) return written;
  }
  if (arguments.json) {
    Json out = document("gap-diagnose");
    add_diagnosis(last.diagnosis(), out);
    console.out << text_of(out);
  } else {
    console.out << diagnosis_text(last.diagnosis());
  }
  console.out << std::flush;
  return done();
}

Outcome gap_next(const Arguments& arguments, Console& console) {
  Session session;
  pb::DiagnoseRequest request;
  pb::DiagnoseEvent last;
  if (auto got = diagnose(arguments, console, session, request, last); !got.ok()) return got;
  const pb::Diagnosis& d = last.diagnosis();
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
