/// A set of blind cases, drawn from one secret.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scheduler/gap/blind/truth.h"

namespace regolab::gap {

struct BlindPlan {
  int cases = 96;  ///< single effects, nulls, pairs and unknowns, in the shares below
  int nulls = 60;  ///< extra ones
  int specimens = 3;
  bool development = false;
};

/// Shares of the main cases [design Sec. 3]: out of 96.
struct Composition {
  int effects = 55, nulls = 14, unknowns = 15, pairs = 12;
};
/// The same for any number of cases, by largest remainders.
Composition composition_of(int cases);

/// The isolability of a truth's weakest effect, before it is run.
using Sight = std::function<double(const Truth&)>;

/// Materials from inside the bank's box, off any grid; strengths from the effects' priors, so that single effects are weak (isolability 1 to
/// 2), medium (2 to 4) and strong (above 4) in turn, and both of a pair strong; a second variant of the law for half of those that have one;
/// seeds, sizes and steps that no bank has. In the order of their random ids, so that any first part of the list is a fair sample.
/// REQUIRES: a secret of 32 bytes.
std::vector<Truth> draw_truths(const BlindPlan& plan, const std::string& secret, const Sight& sight);

/// What single effects are drawn from: a class, and the effects that are ways to have it.
struct CauseMembers {
  std::string cause;
  std::vector<std::string> effects;
};
std::vector<CauseMembers> all_causes();

}  // namespace regolab::gap
