/// What of a set of measurements a bank can speak of.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/emulator.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

/// Something stated that lies outside the bank's materials.
struct OutOfReach {
  std::string key;   ///< of ObservationSet::places
  std::string text;  ///< problem (why) remedy
};

struct Reach {
  std::vector<OutOfReach> refused;  ///< what is stated of the material is none of the bank's: nothing can be compared
  std::vector<Unused> left_out;     ///< measured under conditions that the bank does not have
  std::vector<std::string> warnings;
};

/// Also refused: a set of which nothing is left.
Reach reach_of(const Emulator& emulator, const ObservationSet& set);

}  // namespace regolab::gap
