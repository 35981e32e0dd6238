#include "client/views/study_text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "client/number_text.h"
#include "client/progress.h"
#include "client/table_print.h"

namespace regolab::client {
namespace {

std::string date_text(std::int64_t unix_ms) {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(static_cast<std::time_t>(unix_ms / 1000)));
}

std::string error_freedom(int degrees) {
  if (degrees > 0) return fmt::format("{} error degrees of freedom", degrees);
  return degrees == 0 ? "no error degrees of freedom: no significance can be told without replicate seeds"
                      : "fewer rows than the additive model has coefficients";
}

std::string strength_text(unsigned strength) {
  if (strength == 0) return "not orthogonal";
  if (strength == 1) return "strength 1 (levels balanced, pairs not)";
  return fmt::format("strength {} (orthogonal)", strength);
}

}  // namespace

std::string summary_text(const pb::DesignSummary& s) {
  std::string text = fmt::format("study    {}, profile {}\n", s.name(), s.profile());
  text += fmt::format("array    {}: {} points x {} {}, {}, {}, {}\n", s.array(), s.points(), s.seeds(),
                      s.seeds() == 1 ? "seed" : "seeds", strength_text(s.strength()),
                      s.balanced() ? "balanced" : "not balanced", error_freedom(s.error_degrees_of_freedom()));
  const char* title = "factors ";
  for (const auto& line : s.factor_columns()) {
    text += fmt::format("{} {}\n", title, line);
    title = "        ";
  }
  text += fmt::format("tests    {}\n", fmt::join(s.tests(), ", "));
  text += fmt::format("jobs     {} stages, {} stored already, {} DEM runs to do\n", s.jobs(), s.jobs_stored(), s.dem_jobs());
  for (const auto& note : s.notes()) text += fmt::format("note     {}\n", note);
  return text;
}

std::string list_text(const pb::ListReply& list) {
  std::vector<const pb::ExperimentStatus*> sorted;
  for (const auto& experiment : list.experiments()) sorted.push_back(&experiment);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* a, const auto* b) { return a->created_unix_ms() < b->created_unix_ms(); });
  Table table({{"experiment", "", Align::kLeft},
               {"name", "", Align::kLeft},
               {"state", "", Align::kLeft},
               {"done"},
               {"of"},
               {"running"},
               {"failed"},
               {"no numbers"},
               {"submitted", "", Align::kLeft}});
  for (const auto* e : sorted) {
    const JobProgress jobs = progress_of(e->jobs());
    table.add({e->experiment(), e->name(), e->state(), std::to_string(jobs.done), std::to_string(jobs.total),
               std::to_string(jobs.running), std::to_string(jobs.failed), std::to_string(e->jobs().unphysical()),
               date_text(e->created_unix_ms())});
  }
  return table.text();
}

std::string status_text(const pb::ExperimentStatus& status) {
  const JobProgress jobs = progress_of(status.jobs());
  std::string text = fmt::format("experiment {} ({}): {}\n", status.experiment(), status.name(), status.state());
  text += fmt::format(
      "jobs       {} of {} done ({} reused), {} running, {} waiting, {} failed, {} skipped, {} quarantined, {} cancelled\n",
      jobs.done, jobs.total, jobs.reused, jobs.running, status.jobs().ready() + status.jobs().blocked(),
      status.jobs().failed(), status.jobs().skipped(), status.jobs().quarantined(), status.jobs().cancelled());
  if (status.jobs().unphysical() > 0)
    text += fmt::format("           {} ended with a reason instead of numbers\n", status.jobs().unphysical());
  text += fmt::format("time       {}", duration_text(status.elapsed_s()));
  if (status.state() == "running") {
    text += status.remaining_s() >= 0 ? fmt::format(" so far, about {} left", duration_text(status.remaining_s()))
                                      : " so far, time left not known yet";
    text += fmt::format(", {} workers", status.workers());
  }
  text += "\n";
  if (!status.running().empty()) {
    Table table({{"point"},
                 {"seed"},
                 {"stage", "", Align::kLeft},
                 {"phase", "", Align::kLeft},
                 {"done"},
                 {"sphere-steps/s"},
                 {"worker", "", Align::kLeft}});
    for (const auto& job : status.running()) {
      table.add({std::to_string(job.point()), std::to_string(job.seed()), job.stage(), job.phase(),
                 fmt::format("{:.0f} %", 100 * job.fraction()), large_count(job.sphere_steps_per_s()), job.worker()});
    }
    text += "\n" + table.text();
  }
  if (!status.failures().empty()) text += "\nfailures\n";
  for (const auto& failure : status.failures()) text += "  " + failure + "\n";
  return text;
}

}  // namespace regolab::client
