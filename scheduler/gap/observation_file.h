/// OBSERVATIONS.yaml, `format: observations/1`.
#pragma once
#include <string>

#include "scheduler/gap/observation.h"

namespace regolab::gap {

enum class MissingErrors {
  kRefuse,
  kAssume,  ///< a stated default for each quantity, marked `assumed`
};

/// Every problem at once, each at its place. What can be read but takes no part is listed in `unused`, what is odd in `warnings`.
/// Refused: another format, no or unknown or wrong unit of a known quantity, a value or error that is no finite number, a negative
/// error or one that is missing (unless assumed), lists of unequal length, x that does not ascend, repeats that contradict each other.
Read<ObservationSet> read_observations(const std::string& file_name, const std::string& text,
                                       MissingErrors missing = MissingErrors::kRefuse);

/// The same set in normal form: door units, one spelling of every id. Reading it gives the same set (without `unused`).
std::string observations_yaml(const ObservationSet& set);

}  // namespace regolab::gap
