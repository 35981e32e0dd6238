/// What could be measured next, and what it takes.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "scheduler/gap/comparison.h"

namespace regolab::gap {

/// A test whose result the bank's emulators can foretell.
struct CandidateTest {
  std::string name;                  ///< "stress test at 2.5 kPa", "12 more specimens: repose"
  std::vector<Feature> features;     ///< that it would measure, with the errors it would have
  bool repeated = false;             ///< they are measured already: further specimens of the same
  double hours = 0;                  ///< of a laboratory
};

/// A test that no emulator foretells, and what it would tell apart because of what it measures.
struct OtherTest {
  std::string_view name, one, other;  ///< causes; an empty `other`: anything else
  double hours;
};

/// What the bank has and the set has not, test by test; then more specimens of what it has (four times as many in all: half the error).
/// specimens: of a test that is not there yet.
std::vector<CandidateTest> candidate_tests(const Emulator& emulator, const Comparison& comparison, int specimens, double size_ratio);

/// In a fixed order.
std::span<const OtherTest> other_tests();

}  // namespace regolab::gap
