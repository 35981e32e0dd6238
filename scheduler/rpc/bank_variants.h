/// Rows of the bank that cost no DEM: what an erring apparatus, or a wrong grain density, makes of runs of the base model.
#pragma once
#include <vector>

#include "scheduler/gap/bank.h"
#include "vocab/measurement.h"
#include "vocab/stage.h"

namespace regolab {

struct FinishedStress {
  StageSpec spec;
  StageResult result;
};

/// One of the effects without DEM, which it is and how strong by the point's number: the golden ratio over its prior. Empty when the
/// run has effects already, or no stress test with its curves.
std::vector<gap::BankSource> bank_variants(const gap::BankSource& base, const std::vector<FinishedStress>& stress);

}  // namespace regolab
