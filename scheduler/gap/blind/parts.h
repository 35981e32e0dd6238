/// The DEM runs behind a case: as a rule one material with all tests; where a departure needs it, several.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/blind/truth.h"

namespace regolab::gap {

inline constexpr double kBlindStresses[] = {1250, 2500, 5000, 10000};  ///< sigma3 as said [Pa]

/// A stress test: what it is said to be, and what it is.
struct StressLevel {
  double said = 0, applied = 0;  ///< [Pa]
};

/// One design: a material, and which tests of it the case takes.
struct BlindPart {
  BlindMaterial material;
  bool bed = true;  ///< fabric and repose
  std::vector<StressLevel> stress;
};
std::vector<BlindPart> parts_of(const Truth& truth);

/// Its design.yaml with the table that this names, "case.csv". Numerics as the bank's (scheduler/gap/bank/null.yaml), step and size aside.
struct BlindDesign {
  std::string yaml, table;
};
BlindDesign design_of(const Truth& truth, std::size_t part);

}  // namespace regolab::gap
