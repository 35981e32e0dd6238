#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/design_source.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/study_text.h"

namespace regolab::client {

Outcome rejected(const std::vector<Diagnostic>& diagnostics, const Arguments& arguments, Console& console) {
  console.err << diagnostics_text(diagnostics, console.colour_err);
  if (arguments.json) {
    Json out = document("diagnostics");
    out["diagnostics"] = json_of(diagnostics);
    console.out << text_of(out);
  }
  return failed(Exit::kInvalidInput, "");
}

void hint(const Arguments& arguments, Console& console, const std::string& words) {
  if (arguments.json) return;
  console.err << paint(console.colour_err, Ink::kDim, "next: regolab " + words + where_flags(arguments)) << "\n";
}

Outcome show_design(const Arguments& arguments, Console& console) {
  pb::SubmitRequest request;
  std::vector<Diagnostic> diagnostics;
  if (auto read = read_design_source(arguments, request, diagnostics); !read.ok()) {
    return diagnostics.empty() ? read : rejected(diagnostics, arguments, console);
  }
  Session session;
  if (auto opened = open_session(arguments, Need::kStoredOrScratch, session); !opened.ok()) return opened;
  pb::SubmitReply reply;
  if (auto checked = session.lab->validate(request, reply); !checked.ok()) return session.explain(checked);
  if (!reply.diagnostics().empty()) return rejected(from_proto(reply.diagnostics()), arguments, console);
  if (arguments.json) {
    Json out = document("design");
    out["file"] = arguments.design;
    out["summary"] = json_of(reply.summary());
    console.out << text_of(out);
    return done();
  }
  console.out << summary_text(reply.summary());
  hint(arguments, console, (arguments.server.empty() ? "run " : "submit ") + arguments.design);
  return done();
}

}  // namespace regolab::client
