/// Marks: one answer beside its truth. What counts as right stands here and nowhere else.
///
/// | answer        | right when the truth is                                          |
/// |---------------|------------------------------------------------------------------|
/// | NO GAP        | a null                                                           |
/// | EFFECT k      | one effect of class k                                            |
/// | ONE OF {...}  | what its most probable member says (none, a class, unknown)       |
/// | PAIR a+b      | the pair of classes a and b                                      |
/// | NONE OF THESE | an unknown                                                       |
/// | CANNOT TELL   | an effect or a pair of isolability below 2 (see below), else wrong |
///
/// Isolability below 2 is where the design (section 2.5) says that an effect is not identifiable with these tests, so that not telling is
/// the answer asked for. `strictly_right` leaves that exception out. One member of a pair is not right.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/gap/blind/answer.h"
#include "scheduler/gap/blind/true_gap.h"
#include "scheduler/gap/blind/truth.h"

namespace regolab::gap {

/// Everything that may be answered: "none", "unknown", each class, each pair of classes.
const std::vector<std::string>& all_answers();

/// What one way of answering says of a case. Probabilities over all_answers(), after a share of kDoubt was spread evenly: an answer
/// that was called impossible costs -ln(kDoubt/n), not everything. The same for all ways.
struct Opinion {
  std::string named;
  std::map<std::string, double> p;
};
inline constexpr double kDoubt = 0.01;
Opinion doubting(std::string named, const std::map<std::string, double>& p);

/// Of the shrinkage of a case, measured by new runs (`gap confirm`).
struct MeasuredShrinkage {
  double s = 0, low = 0, high = 0;  ///< S with its 90 % interval
};

struct StrengthMark {
  std::string effect, unit;
  double truth = 0, median = 0, low = 0, high = 0;
  double log_error() const;  ///< |ln(median/truth)|; infinite when the signs differ
  bool covered() const { return truth >= low && truth <= high; }
};

struct Mark {
  Truth truth;
  std::string answer;              ///< the right one
  std::string verdict;             ///< "EFFECT", ...
  Opinion ours;                    ///< named: "" of CANNOT TELL
  std::vector<std::string> listed; ///< all that the verdict names; nothing of CANNOT TELL
  double declared_confidence = 0;  ///< probability of the most probable answer
  bool right = false, strictly_right = false;
  std::optional<TrueGap> gap;
  std::optional<StrengthMark> strength;  ///< of single effects whose model was weighed, named or not
  std::optional<bool> where;             ///< the truly moved group stands first
  std::optional<MeasuredShrinkage> shrinkage;
  std::map<std::string, Opinion> baselines;  ///< lowest_rms, bic, nearest_pattern; the first and the last without probabilities yet
  std::string problem, protection;
  double adequacy = 0;
};

Mark mark_of(const Truth& truth, const Answer& answer, const std::optional<TrueGap>& gap, const std::optional<MeasuredShrinkage>& shrinkage);

}  // namespace regolab::gap
