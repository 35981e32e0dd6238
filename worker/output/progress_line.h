/// How far a run is, in one line for people.
#pragma once
#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include "worker/output/job_run.h"

namespace regolab {

/// "[2/7] repose: collapse, 45 %, 12000 steps, 2.1e+06 sphere-steps/s, 1:05 left"
std::string progress_text(const StagePlace& place, const StageProgress& progress, std::optional<double> seconds_left);

/// "stress at 2.5 kPa", "settle", ...
std::string place_text(const StagePlace& place);

/// On a terminal one line, rewritten; elsewhere a line every half minute. One line when a stage ends.
class ProgressLine {
 public:
  /// `seconds` is a steady clock; `out` must outlive this.
  ProgressLine(std::ostream& out, bool terminal, std::function<double()> seconds)
      : out_(out), terminal_(terminal), seconds_(std::move(seconds)) {}

  void show(const StagePlace& place, const StageProgress& progress);
  void finish(const StagePlace& place, const FinishedStage& stage);
  /// A message on a line of its own.
  void note(const std::string& text);

 private:
  std::optional<double> seconds_left(const StagePlace& place, double fraction, double now);
  void clear_line();

  std::ostream& out_;
  bool terminal_;
  std::function<double()> seconds_;
  std::size_t stage_ = 0;       ///< the number of the stage shown last
  double stage_start_ = 0;      ///< when its first progress came [s]
  double start_fraction_ = 0;   ///< and what it said: above zero after a resume
  double shown_at_ = -1e9;      ///< [s]
  std::size_t shown_size_ = 0;  ///< characters now standing on the terminal's line
};

}  // namespace regolab
