#include "client/session.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "client/interrupt.h"

namespace regolab::client {
namespace {

using namespace std::chrono_literals;

constexpr auto kEmbeddedPatience = 60s;  // a killed scheduler is back within seconds

Outcome dial(const std::string& address, Session& session) {
  session.lab = std::make_unique<Lab>(Lab::Options{.address = address, .stops = {interrupted()}});
  return session.lab->reach();
}

/// Which experiments the words may mean.
std::vector<std::string> matches(const pb::ListReply& list, const std::string& wanted) {
  std::vector<std::string> found;
  for (const auto& experiment : list.experiments()) {
    if (experiment.experiment() == wanted) return {wanted};
    if (experiment.experiment().starts_with(wanted) || experiment.name() == wanted) found.push_back(experiment.experiment());
  }
  return found;
}

const pb::ExperimentStatus* newest(const pb::ListReply& list) {
  const pb::ExperimentStatus* best = nullptr;
  for (const auto& experiment : list.experiments()) {
    if (best == nullptr || experiment.created_unix_ms() >= best->created_unix_ms()) best = &experiment;
  }
  return best;
}

}  // namespace

Outcome Session::explain(Outcome outcome) const {
  if (outcome.ok() || !embedded || !embedded->broken().stop_requested() || interrupted().stop_requested()) return outcome;
  return embedded->failure();
}

Outcome open_session(const Arguments& arguments, Need need, Session& session) {
  session.lab.reset();
  session.embedded.reset();
  session.scratch = false;
  if (!arguments.server.empty()) return dial(arguments.server, session);

  std::error_code ignored;
  const bool exists = std::filesystem::exists(arguments.database, ignored);
  if (need == Need::kStored && !exists) {
    return failed(
        Exit::kInvalidInput,
        fmt::format("no database {} (nothing was run here yet) run a study first: regolab run DESIGN.yaml; or name another "
                    "with --db FILE, or a scheduler with --server ADDR",
                    arguments.database));
  }
  session.scratch = need == Need::kScratch || (need == Need::kStoredOrScratch && !exists);
  if (!session.scratch) {
    const std::string running = running_scheduler_of(arguments.database);
    if (!running.empty()) return dial(running, session);
  }
  const Embedded::Options options{.programs = program_folder(), .database = session.scratch ? "" : arguments.database};
  if (auto up = Embedded::start(options, session.embedded); !up.ok()) {
    const bool named = session.scratch || up.text.find(arguments.database) != std::string::npos;
    return named ? up : failed(up.exit, arguments.database + ": " + up.text);
  }
  session.lab = std::make_unique<Lab>(Lab::Options{.address = session.embedded->address(),
                                                   .stops = {interrupted(), session.embedded->broken()},
                                                   .patience = kEmbeddedPatience});
  return done();
}

Outcome resolve_experiment(Lab& lab, const Arguments& arguments, Console& console, std::string& id) {
  pb::ListReply list;
  if (auto listed = lab.list(list); !listed.ok()) return listed;
  const std::string& wanted = arguments.experiment;
  if (list.experiments().empty()) {
    return failed(Exit::kUsage,
                  "no experiments (nothing was submitted yet) run one: regolab run DESIGN.yaml" + where_flags(arguments));
  }
  if (wanted.empty() || wanted == "last") {
    const pb::ExperimentStatus* last = newest(list);
    id = last->experiment();
    if (wanted.empty() && list.experiments_size() > 1)
      console.err << fmt::format("experiment {} ({}), the last one\n", id, last->name());
    return done();
  }
  const auto found = matches(list, wanted);
  if (found.size() == 1) {
    id = found.front();
    return done();
  }
  const std::string why = found.empty() ? fmt::format("{} experiments, none of that id or name", list.experiments_size())
                                        : fmt::format("it may be {}", fmt::join(found, " or "));
  return failed(Exit::kUsage, fmt::format("experiment `{}` (no one experiment: {}) see: regolab status{}", wanted, why,
                                          where_flags(arguments)));
}

Outcome resolve_experiments(Lab& lab, const Arguments& arguments, Console& console, google::protobuf::RepeatedPtrField<std::string>& ids) {
  for (const std::string& word : arguments.experiments) {
    Arguments one = arguments;
    one.experiment = word;
    if (auto found = resolve_experiment(lab, one, console, *ids.Add()); !found.ok()) return found;
  }
  return done();
}

}  // namespace regolab::client
