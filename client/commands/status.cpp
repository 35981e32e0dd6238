#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/study_text.h"

namespace regolab::client {
namespace {

/// Opens, finds the experiment, and asks for its status in one of three ways.
Outcome ask(const Arguments& arguments, Console& console, pb::ExperimentStatus& reply,
            Outcome (Lab::*call)(const std::string&, pb::ExperimentStatus&)) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  std::string id;
  if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);
  return session.explain((session.lab.get()->*call)(id, reply));
}

void print(const Arguments& arguments, Console& console, const pb::ExperimentStatus& reply) {
  if (!arguments.json) {
    console.out << status_text(reply) << std::flush;
    return;
  }
  Json out = document(arguments.verb);
  out["status"] = json_of(reply);
  console.out << text_of(out);
}

Outcome list_all(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  pb::ListReply list;
  if (auto listed = session.lab->list(list); !listed.ok()) return session.explain(listed);
  if (arguments.json) {
    Json out = document("status");
    out["experiments"] = Json::array();
    for (const auto& experiment : list.experiments()) out["experiments"].push_back(json_of(experiment));
    console.out << text_of(out);
    return done();
  }
  if (list.experiments().empty()) {
    console.err << "no experiments yet\n";
    hint(arguments, console, "run client/examples/article-l32.yaml");
    return done();
  }
  console.out << list_text(list) << std::flush;
  hint(arguments, console, "status last");
  return done();
}

}  // namespace

Outcome status(const Arguments& arguments, Console& console) {
  if (arguments.experiment.empty()) return list_all(arguments, console);
  pb::ExperimentStatus reply;
  if (auto asked = ask(arguments, console, reply, &Lab::get); !asked.ok()) return asked;
  print(arguments, console, reply);
  hint(arguments, console, (reply.state() == "running" ? "watch " : "range ") + reply.experiment());
  return done();
}

Outcome cancel(const Arguments& arguments, Console& console) {
  pb::ExperimentStatus reply;
  if (auto asked = ask(arguments, console, reply, &Lab::cancel); !asked.ok()) return asked;
  print(arguments, console, reply);
  hint(arguments, console, "retry " + reply.experiment());
  return done();
}

Outcome retry(const Arguments& arguments, Console& console) {
  pb::ExperimentStatus reply;
  if (auto asked = ask(arguments, console, reply, &Lab::retry); !asked.ok()) return asked;
  print(arguments, console, reply);
  hint(arguments, console, "watch " + reply.experiment());
  return done();
}

}  // namespace regolab::client
