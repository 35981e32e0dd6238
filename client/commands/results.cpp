#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/csv_write.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/range_text.h"
#include "client/views/results_text.h"

namespace regolab::client {
namespace {

std::string rendered(const Arguments& arguments, const pb::ResultsReply& reply) {
  if (arguments.csv) return results_csv(reply);
  if (!arguments.json) return results_text(reply, arguments.all);
  Json out = document("results");
  add_results(reply, out);
  return text_of(out);
}

std::string rendered(const Arguments& arguments, const pb::RangeReply& reply) {
  if (arguments.csv) return range_csv(reply);
  if (arguments.json) {
    Json out = document("range");
    out["experiment"] = reply.experiment();
    out["responses"] = json_of(reply);
    return text_of(out);
  }
  std::string text;
  for (const auto& response : reply.responses()) text += range_detail_text(response) + "\n";
  if (reply.responses_size() > 1) return text + range_matrix_text(reply);
  return text + "* p < 0.05, ! fragile: leans on one run; ± standard error over seeds, 95 % of the level means\n";
}

}  // namespace

Outcome results(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  std::string id;
  if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);
  pb::ResultsReply reply;
  if (auto got = session.lab->results(id, reply); !got.ok()) return session.explain(got);
  const std::string text = rendered(arguments, reply);
  if (arguments.output.empty()) {
    console.out << text << std::flush;
  } else {
    if (auto written = write_file(arguments.output, text); !written.ok()) return written;
    console.err << fmt::format("{} rows written to {}\n", reply.rows_size(), arguments.output);
  }
  if (!arguments.csv) hint(arguments, console, "range " + id);
  return done();
}

Outcome range(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, arguments.article ? Need::kScratch : Need::kStored, session); !opened.ok())
    return opened;
  pb::RangeRequest request;
  if (!arguments.article) {
    if (auto found = resolve_experiment(*session.lab, arguments, console, *request.mutable_experiment()); !found.ok())
      return session.explain(found);
  }
  request.set_response(arguments.response);
  for (const int point : arguments.without) request.add_without(point);
  pb::RangeReply reply;
  if (auto got = session.lab->range(request, reply); !got.ok()) return session.explain(got);
  console.out << rendered(arguments, reply) << std::flush;
  if (!arguments.json && !arguments.csv)
    hint(arguments, console,
         arguments.article ? "article check" : "results " + request.experiment() + " --csv -o results.csv");
  return done();
}

}  // namespace regolab::client
