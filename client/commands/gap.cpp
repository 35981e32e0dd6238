#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/design_source.h"
#include "client/file_read.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/commands/gap.h"
#include "client/session.h"
#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

constexpr std::size_t kLargestObservations = 16 << 20;  // [bytes]; the scheduler's limit as well
constexpr std::size_t kLargestMap = 1 << 20;            // [bytes]

}  // namespace

Outcome read_measurements(const Arguments& arguments, pb::ImportRequest& request) {
  std::string text;
  if (auto read = read_whole_file(arguments.observations, kLargestObservations, "an observation file", text); !read.ok()) return read;
  request.set_file_name(arguments.observations);
  request.set_content(text);
  request.set_assume_errors(arguments.assume_errors);
  request.set_want_file(!arguments.output.empty());
  if (arguments.map.empty()) {
    if (arguments.observations.ends_with(".csv")) {
      return failed(Exit::kUsage, arguments.observations + " is a CSV (nothing says what its columns are) add --map MAP.yaml");
    }
    return done();
  }
  if (auto read = read_whole_file(arguments.map, kLargestMap, "a map of the CSV's columns", text); !read.ok()) return read;
  request.set_map_name(arguments.map);
  request.set_map(text);
  return done();
}

namespace {

Json feature_json(const pb::FeatureValue& f) {
  return {{"id", f.id()}, {"label", f.label()}, {"group", f.group()}, {"value", f.value()}, {"standard_error", f.standard_error()}, {"logarithm", f.logarithm()},
          {"assumed", f.assumed()}, {"repeats", f.repeats()}, {"unit", f.unit()}, {"shown", f.shown()}, {"shown_error", f.shown_error()}};
}

void add_import(const pb::ImportReply& reply, Json& out) {
  out["case"] = reply.name();
  out["scalars"] = reply.scalars();
  out["curves"] = reply.curves();
  out["few"] = reply.few();
  out["assumed_errors"] = reply.assumed();
  out["features"] = Json::array();
  for (const auto& feature : reply.features()) out["features"].push_back(feature_json(feature));
  out["unused"] = Json::array();
  for (const auto& entry : reply.unused()) out["unused"].push_back({{"id", entry.id()}, {"why", entry.why()}});
  out["warnings"] = json_of(from_proto(reply.warnings()));
}

}  // namespace

Outcome gap_import(const Arguments& arguments, Console& console) {
  pb::ImportRequest request;
  if (auto read = read_measurements(arguments, request); !read.ok()) return read;
  Session session;
  if (auto opened = open_session(arguments, Need::kScratch, session); !opened.ok()) return opened;
  pb::ImportReply reply;
  if (auto got = session.lab->import_observations(request, reply); !got.ok()) return session.explain(got);
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  if (!arguments.output.empty()) {
    if (auto written = write_file(arguments.output, reply.file()); !written.ok()) return written;
  }
  if (arguments.json) {
    Json out = document("gap-import");
    add_import(reply, out);
    console.out << text_of(out);
    return done();
  }
  console.out << import_text(reply) << std::flush;
  for (const Diagnostic& warning : from_proto(reply.warnings())) console.err << paint(console.colour_err, Ink::kYellow, "warning: ") << to_text(warning) << "\n";
  if (reply.assumed()) console.err << "some errors are assumed: every verdict on them rests on the assumption\n";
  console.err << std::flush;
  return done();
}

Outcome gap_bank(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  pb::BankRequest request;
  if (auto found = resolve_experiments(*session.lab, arguments, console, *request.mutable_experiments()); !found.ok()) return session.explain(found);
  pb::BankReply reply;
  if (auto got = session.lab->bank(request, reply); !got.ok()) return session.explain(got);
  if (!arguments.output.empty()) {
    if (auto written = write_file(arguments.output, reply.csv()); !written.ok()) return written;
  }
  if (arguments.json) {
    Json out = document("gap-bank");
    out["rows"] = reply.rows();
    out["without_numbers"] = reply.without_numbers();
    out["inputs"] = std::vector<std::string>(reply.inputs().begin(), reply.inputs().end());
    out["features"] = std::vector<std::string>(reply.features().begin(), reply.features().end());
    out["file"] = arguments.output.empty() ? Json() : Json(arguments.output);
    console.out << text_of(out);
    return done();
  }
  if (arguments.output.empty()) console.out << reply.csv() << std::flush;
  console.err << fmt::format("{} rows (points times seeds), {} inputs, {} features; {} without numbers left out\n", reply.rows(), reply.inputs_size(), reply.features_size(),
                             reply.without_numbers())
              << std::flush;
  return done();
}

}  // namespace regolab::client
