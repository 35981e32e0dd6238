#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/commands/work.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/study_text.h"

namespace regolab::client {

Outcome watch(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  std::string id;
  if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);

  Json events = Json::array();
  FollowOptions options{.from_seq = arguments.from_seq, .timeout_s = arguments.timeout_s, .verbose = arguments.verbose};
  options.on_event = [&](const pb::WatchEvent& event) {
    if (arguments.json_lines)
      console.out << line_of(json_of(event)) << std::flush;
    else if (arguments.json)
      events.push_back(json_of(event));
  };
  pb::ExperimentStatus last;
  const Outcome worked = work(arguments, id, session, options, console, last);
  if (worked.exit == Exit::kInterrupted) {
    const std::string from = options.from_seq > 0 ? fmt::format(" --from-seq {}", options.from_seq) : "";
    return leave_interrupted(arguments, "regolab watch " + id + from + where_flags(arguments), session, console);
  }
  if (!worked.ok()) return worked;
  if (arguments.json_lines) return verdict_of(last);
  if (arguments.json) {
    Json out = document("watch");
    out["status"] = json_of(last);
    out["events"] = events;
    out["next_seq"] = options.from_seq;
    console.out << text_of(out);
    return verdict_of(last);
  }
  console.out << status_text(last) << std::flush;
  hint(arguments, console, "range " + id);
  return verdict_of(last);
}

}  // namespace regolab::client
