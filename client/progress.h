/// One line that says how far a study is: rewritten in place on a terminal, a plain line every 30 s elsewhere.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "client/console.h"
#include "client/wire.h"

namespace regolab::client {

/// Jobs that will not change any more, and all there are.
struct JobProgress {
  unsigned done = 0;    ///< succeeded, with or without numbers
  unsigned failed = 0;  ///< failed, skipped or quarantined
  unsigned running = 0;
  unsigned total = 0;
  unsigned reused = 0;  ///< of done: taken from the store
};
JobProgress progress_of(const pb::JobCounts& jobs);

/// "article-l32  37/224 done, 2 running, 0 failed, 1.9 jobs/min, 12 min left | settle sedimentation 43 %".
/// `jobs_per_s` is left out when not known yet; text beyond `width` columns is cut.
std::string progress_text(const pb::ExperimentStatus& status, std::optional<double> jobs_per_s, int width);

class ProgressLine {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  /// `console` must outlive this.
  explicit ProgressLine(Console& console, Clock clock = std::chrono::steady_clock::now);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const pb::ExperimentStatus& status);
  /// A line that stays, above the progress line.
  void say(const std::string& line);
  /// Takes the rewritten line away.
  void clear();

 private:
  std::optional<double> rate(const JobProgress& progress);

  Console& console_;
  Clock clock_;
  std::optional<std::chrono::steady_clock::time_point> first_seen_;
  std::optional<std::chrono::steady_clock::time_point> last_line_;
  unsigned finished_at_first_ = 0;
  bool on_screen_ = false;
};

}  // namespace regolab::client
