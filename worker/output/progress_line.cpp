#include "worker/output/progress_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "worker/output/number_text.h"

namespace regolab {
namespace {

constexpr double kTerminalPause = 0.2;  // [s] between two looks
constexpr double kPlainPause = 30;

std::string clock_text(double seconds) {
  const long all = std::lround(std::min(seconds, 359999.0));
  char text[32];
  if (all >= 3600)
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", all / 3600, all / 60 % 60, all % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld", all / 60, all % 60);
  return text;
}

std::string rate_text(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", rate);
  return text;
}

}  // namespace

std::string place_text(const StagePlace& place) {
  std::string text = stage_name(place.spec.kind);
  if (place.spec.kind == StageKind::kStress)
    text += " at " + shortest_text(shown_value(place.spec.confining_stress, 1e-3)) + " kPa";
  if (place.spec.kind == StageKind::kPenetration) text += " of " + plate_text(place.spec.plate);
  return text;
}

std::string progress_text(const StagePlace& place, const StageProgress& progress, std::optional<double> seconds_left) {
  std::string text = "[" + std::to_string(place.number) + "/" + std::to_string(place.count) + "] " + place_text(place);
  if (!progress.phase.empty()) text += ": " + std::string(progress.phase);
  text += ", " + std::to_string(std::lround(100 * std::clamp(progress.fraction, 0.0, 1.0))) + " %";
  text += ", " + std::to_string(progress.steps) + " steps, " + rate_text(progress.sphere_steps_per_s) + " sphere-steps/s";
  return text + (seconds_left ? ", " + clock_text(*seconds_left) + " left" : "");
}

std::optional<double> ProgressLine::seconds_left(const StagePlace& place, double fraction, double now) {
  if (place.number != stage_) {
    stage_ = place.number;
    stage_start_ = now;
    start_fraction_ = fraction;
  }
  if (fraction - start_fraction_ < 0.01) return std::nullopt;  // too early to tell
  return (now - stage_start_) * (1 - fraction) / (fraction - start_fraction_);
}

void ProgressLine::clear_line() {
  if (terminal_ && shown_size_ > 0) out_ << '\r' << std::string(shown_size_, ' ') << '\r';
  shown_size_ = 0;
}

void ProgressLine::show(const StagePlace& place, const StageProgress& progress) {
  const double now = seconds_();
  const auto left = seconds_left(place, progress.fraction, now);
  if (now - shown_at_ < (terminal_ ? kTerminalPause : kPlainPause)) return;
  shown_at_ = now;
  const std::string text = progress_text(place, progress, left);
  clear_line();
  out_ << text;
  if (terminal_)
    shown_size_ = text.size();
  else
    out_ << '\n';
  out_.flush();
}

void ProgressLine::finish(const StagePlace& place, const FinishedStage& stage) {
  std::string text = "[" + std::to_string(place.number) + "/" + std::to_string(place.count) + "] " + place_text(place) +
                     ": " + std::string(name_of(stage.result.end)) + ", " + std::to_string(stage.steps) + " steps, " +
                     clock_text(stage.wall_s);
  if (!stage.result.reason.empty()) text += "; " + stage.result.reason;
  note(text);
}

void ProgressLine::note(const std::string& text) {
  clear_line();
  out_ << text << std::endl;
}

}  // namespace regolab
