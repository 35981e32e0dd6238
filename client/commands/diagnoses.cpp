/// Diagnoses in the store: listed, shown, reported; and the "where" of one alone.
#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/commands/gap.h"
#include "client/design_source.h"
#include "client/file_write.h"
#include "client/table_print.h"
#include "client/views/gap_html.h"
#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

std::string time_text(std::int64_t unix_ms) {
  const std::time_t seconds = unix_ms / 1000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local)};
}

std::string state_of(const pb::StoredDiagnosis& d) { return d.ended_unix_ms() > 0 ? d.diagnosis().verdict() : fmt::format("{} steps done", d.steps_size()); }

std::string shrinkage_of(const pb::Diagnosis& d) {
  if (!d.has_shrinkage()) return "";
  return d.shrinkage().has_s() ? fmt::format("{:.0f} %", 100 * d.shrinkage().s()) : "undefined";
}

/// A file stands for the newest finished diagnosis of it, anything else is an id.
Outcome get(const Arguments& arguments, Session& session, pb::StoredDiagnosis& found) {
  pb::GetDiagnosisRequest request;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(arguments.diagnosis, ignored)) {
    Arguments file = arguments;
    file.observations = arguments.diagnosis;
    if (auto read = read_measurements(file, *request.mutable_measurements()); !read.ok()) return read;
  } else {
    request.set_id(arguments.diagnosis);
  }
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  if (auto got = session.lab->diagnosis(request, found); !got.ok()) return session.explain(got);
  if (found.ended_unix_ms() > 0) return done();
  return failed(Exit::kInvalidInput, fmt::format("diagnosis {} has not ended ({} steps are done) repeat its `regolab gap diagnose`: it goes on with them", found.id().substr(0, 12), found.steps_size()));
}

}  // namespace

Outcome gap_ls(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  pb::ListDiagnosesReply reply;
  if (auto got = session.lab->diagnoses(reply); !got.ok()) return session.explain(got);
  if (arguments.json) {
    Json out = document("gap-ls");
    out["diagnoses"] = Json::array();
    for (const auto& d : reply.diagnoses()) {
      out["diagnoses"].push_back({{"id", d.id()}, {"case", d.case_name()}, {"created_unix_ms", d.created_unix_ms()}, {"finished", d.ended_unix_ms() > 0}, {"held_out", d.held_out()},
                                  {"verdict", d.ended_unix_ms() > 0 ? Json(d.diagnosis().verdict()) : Json()}, {"steps", d.steps_size()},
                                  {"classes", std::vector<std::string>(d.diagnosis().classes().begin(), d.diagnosis().classes().end())},
                                  {"S", d.diagnosis().has_shrinkage() && d.diagnosis().shrinkage().has_s() ? Json(d.diagnosis().shrinkage().s()) : Json()}});
    }
    console.out << text_of(out) << std::flush;
    return done();
  }
  if (reply.diagnoses().empty()) console.err << "no diagnosis here (nothing was diagnosed yet) begin with: regolab gap diagnose OBSERVATIONS.yaml\n";
  Table table({{"id", "", Align::kLeft}, {"case", "", Align::kLeft}, {"when", "", Align::kLeft}, {"verdict", "", Align::kLeft}, {"classes", "", Align::kLeft},
               {"shrinks by"}, {"fitted without", "", Align::kLeft}});
  for (const auto& d : reply.diagnoses()) {
    const auto& classes = d.diagnosis().classes();
    table.add({d.id().substr(0, 12), d.case_name(), time_text(d.created_unix_ms()), state_of(d), fmt::format("{}", fmt::join(classes.begin(), classes.end(), ", ")),
               shrinkage_of(d.diagnosis()), d.held_out()});
  }
  if (!table.empty()) console.out << table.text();
  console.out.flush();
  return done();
}

Outcome gap_show(const Arguments& arguments, Console& console) {
  Session session;
  pb::StoredDiagnosis found;
  if (auto got = get(arguments, session, found); !got.ok()) return got;
  if (arguments.json) {
    Json out = document("gap-show");
    add_diagnosis(found.diagnosis(), out);
    out["steps"] = Json::array();
    for (const auto& step : found.steps()) out["steps"].push_back({{"name", step.name()}, {"done_unix_ms", step.done_unix_ms()}});
    console.out << text_of(out) << std::flush;
    return done();
  }
  console.out << diagnosis_text(found.diagnosis()) << std::flush;
  return done();
}

Outcome write_report(const std::string& id, const std::string& file, Session& session) {
  pb::GetDiagnosisRequest request;
  request.set_id(id);
  pb::StoredDiagnosis found;
  if (auto got = session.lab->diagnosis(request, found); !got.ok()) return session.explain(got);
  return write_file(file, diagnosis_html({.stored = found, .blind_record = std::string(blind_record())}));
}

Outcome gap_report(const Arguments& arguments, Console& console) {
  Session session;
  pb::StoredDiagnosis found;
  if (auto got = get(arguments, session, found); !got.ok()) return got;
  if (auto written = write_report(found.id(), arguments.output, session); !written.ok()) return written;
  if (!arguments.json) return done();
  Json out = document("gap-report");
  out["diagnosis"] = found.id(), out["file"] = arguments.output;
  console.out << text_of(out) << std::flush;
  return done();
}

Outcome gap_locate(const Arguments& arguments, Console& console) {
  pb::DiagnoseRequest request;
  Session session;
  if (auto opened = open_question(arguments, console, request, session); !opened.ok()) return opened;
  pb::DiagnoseEvent last;
  const auto show = [&](const pb::DiagnoseEvent&) { console.err << "each group beside what the others foretell ...\n" << std::flush; };
  if (auto got = session.lab->locate(request, show, last); !got.ok()) return session.explain(got);
  if (!last.diagnostics().empty()) return rejected(from_proto(last.diagnostics()), arguments, console);
  if (!arguments.json) {
    console.out << where_text(last.diagnosis()) << std::flush;
    hint(arguments, console, "gap diagnose " + question_words(arguments));
    return done();
  }
  Json whole, out = document("gap-locate");
  add_diagnosis(last.diagnosis(), whole);
  for (const char* key : {"case", "where", "provenance"}) out[key] = whole[key];
  console.out << text_of(out) << std::flush;
  return done();
}

}  // namespace regolab::client
