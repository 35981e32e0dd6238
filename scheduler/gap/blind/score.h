/// The figures of a set of marks [design Sec. 3].
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scheduler/gap/blind/intervals.h"
#include "scheduler/gap/blind/marks.h"

namespace regolab::gap {

/// One figure beside what was asked for; `target` empty where nothing was.
struct Figure {
  std::string name, what, target;
  Interval value;
};

/// One way of answering, on the main cases.
struct MethodScore {
  std::string name;
  Interval top1, log_score, brier;                ///< log score: mean of -ln P(right), lower is better, as Brier
  Interval log_score_less_ours, brier_less_ours;  ///< paired; above 0: ours is better
};

struct Score {
  bool development = false;
  int cases = 0, extra = 0, missing = 0;  ///< missing: committed to, not answered
  std::vector<Figure> figures;
  std::vector<MethodScore> methods;          ///< ours first
  std::map<std::string, Interval> unknowns;  ///< by kind: detected
  std::map<std::string, Interval> effects;   ///< by class: right
};

/// The baselines without probabilities of their own get, in hindsight, the one confidence that suits them best: the share that they had
/// right, the rest spread evenly. A last one, "commonest", always names the commonest answer and knows the shares of all.
Score score_of(std::vector<Mark>& marks, int missing);

double log_score(const Opinion& opinion, const std::string& answer);
double brier(const Opinion& opinion, const std::string& answer);

}  // namespace regolab::gap
