#include "client/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "client/number_text.h"
#include "client/table_print.h"

namespace regolab::client {
namespace {

using namespace std::chrono_literals;

constexpr auto kPlainEvery = 30s;
constexpr auto kRewriteEvery = 100ms;
constexpr double kRateNeeds = 5.0;  // [s] before a rate means anything

/// What the workers are at: "settle sedimentation 43 %, stress shear 7 %".
std::string running_text(const pb::ExperimentStatus& status) {
  std::vector<std::string> parts;
  double speed = 0;
  for (const auto& job : status.running()) {
    const std::string phase = job.phase().empty() || job.phase() == job.stage() ? "" : " " + job.phase();
    parts.push_back(fmt::format("{}{} {:.0f} %", job.stage(), phase, 100 * job.fraction()));
    speed += job.sphere_steps_per_s();
  }
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  if (speed > 0) text += fmt::format(", {} sphere-steps/s", large_count(speed));
  return text;
}

std::string cut(const std::string& text, int width) {
  if (display_width(text) <= width) return text;
  std::size_t end = 0;
  for (int shown = 0; end < text.size() && shown < width - 1; ++shown) {
    do ++end;
    while (end < text.size() && (text[end] & 0xC0) == 0x80);
  }
  return text.substr(0, end) + "…";
}

}  // namespace

JobProgress progress_of(const pb::JobCounts& jobs) {
  const unsigned failed = jobs.failed() + jobs.skipped() + jobs.quarantined();
  return {.done = jobs.succeeded(),
          .failed = failed,
          .running = jobs.running(),
          .total = jobs.blocked() + jobs.ready() + jobs.running() + jobs.succeeded() + jobs.cancelled() + failed,
          .reused = jobs.reused()};
}

std::string progress_text(const pb::ExperimentStatus& status, std::optional<double> jobs_per_s, int width) {
  const JobProgress progress = progress_of(status.jobs());
  std::string text = fmt::format("{}  {}/{} done, {} running, {} failed", status.name(), progress.done, progress.total,
                                 progress.running, progress.failed);
  if (status.jobs().unphysical() > 0) text += fmt::format(", {} without numbers", status.jobs().unphysical());
  if (jobs_per_s) text += fmt::format(", {} jobs/min", significant(60 * *jobs_per_s, 2));
  const bool ended = progress.done + progress.failed == progress.total;
  if (!ended && status.workers() == 0)
    text += ", no workers yet";
  else if (!ended && status.remaining_s() >= 0)
    text += fmt::format(", about {} left", duration_text(status.remaining_s()));
  const std::string now = running_text(status);
  if (!now.empty()) text += " | " + now;
  return cut(text, width);
}

ProgressLine::ProgressLine(Console& console, Clock clock) : console_(console), clock_(std::move(clock)) {}

std::optional<double> ProgressLine::rate(const JobProgress& progress) {
  const auto now = clock_();
  const unsigned finished = progress.done + progress.failed;
  if (!first_seen_) {
    first_seen_ = now;
    finished_at_first_ = finished;
  }
  const double seconds = std::chrono::duration<double>(now - *first_seen_).count();
  if (seconds < kRateNeeds || finished <= finished_at_first_) return std::nullopt;
  return (finished - finished_at_first_) / seconds;
}

void ProgressLine::show(const pb::ExperimentStatus& status) {
  const auto jobs_per_s = rate(progress_of(status.jobs()));
  const auto now = clock_();
  if (last_line_ && now - *last_line_ < (console_.live ? std::chrono::milliseconds(kRewriteEvery) : kPlainEvery)) return;
  last_line_ = now;
  if (!console_.live) {
    console_.err << progress_text(status, jobs_per_s, 1000) << std::endl;
    return;
  }
  console_.err << "\r\x1b[K" << progress_text(status, jobs_per_s, console_.width - 1) << std::flush;
  on_screen_ = true;
}

void ProgressLine::say(const std::string& line) {
  clear();
  console_.err << line << std::endl;
  if (console_.live) last_line_.reset();  // the rewritten line is back with the next status
}

void ProgressLine::clear() {
  if (on_screen_) console_.err << "\r\x1b[K" << std::flush;
  on_screen_ = false;
}

}  // namespace regolab::client
