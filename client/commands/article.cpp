#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/json_view.h"
#include "client/session.h"
#include "client/views/functions_text.h"
#include "client/views/results_text.h"

namespace regolab::client {

Outcome check_article(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kScratch, session); !opened.ok()) return opened;
  pb::CheckArticleReply reply;
  if (auto got = session.lab->check_article(reply); !got.ok()) return session.explain(got);
  if (arguments.json) {
    Json out = document("article-check");
    add_check(reply, out);
    console.out << text_of(out);
    return done();
  }
  console.out << check_text(reply, arguments.all) << std::flush;
  if (!arguments.all) hint(arguments, console, "article check --all");
  return done();
}

Outcome compare_article(const Arguments& arguments, Console& console) {
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  std::string id;
  if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);
  pb::CompareArticleReply reply;
  if (auto got = session.lab->compare_article(id, reply); !got.ok()) return session.explain(got);
  if (arguments.json) {
    Json out = document("article-compare");
    add_comparison(reply, out);
    console.out << text_of(out);
    return done();
  }
  console.out << comparison_text(reply) << std::flush;
  hint(arguments, console, "range " + id);
  return done();
}

Outcome article_functions(const Arguments& arguments, Console& console) {
  Session session;
  const bool stored = !arguments.experiment.empty();
  if (auto opened = open_session(arguments, stored ? Need::kStored : Need::kScratch, session); !opened.ok()) return opened;
  std::string id;
  if (stored) {
    if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);
  }
  pb::TrainFunctionsReply reply;
  if (auto got = session.lab->train_functions(id, arguments.random_seed, reply); !got.ok()) return session.explain(got);
  if (arguments.json) {
    Json out = document("article-functions");
    add_functions(reply, out);
    console.out << text_of(out);
    return done();
  }
  console.out << functions_text(reply) << std::flush;
  hint(arguments, console, stored ? "range " + id : "article check");
  return done();
}

}  // namespace regolab::client
