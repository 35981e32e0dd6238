/// What a known truth does to the features of a case: how far it stands out of what calibration can do, and where most. Of singles and
/// pairs of library effects; computed after the answers, from the emulator.
#pragma once
#include <optional>
#include <string>

#include "scheduler/gap/blind/truth.h"
#include "scheduler/gap/hypothesis.h"

namespace regolab::gap {

struct TrueGap {
  double isolability = 0;  ///< [sigma] at the true strength and material; of a pair, of the weaker one
  std::string moved;       ///< group with the largest shift that calibration leaves
};

/// Nothing for nulls and unknowns, and where the emulator lacks the effect.
std::optional<TrueGap> true_gap(const Emulator& emulator, const ObservationSet& set, const Truth& truth);

/// The isolability that the tests of a case would have, from its truth alone: before anything is run.
std::optional<double> expected_isolability(const Emulator& emulator, const Truth& truth);

}  // namespace regolab::gap
