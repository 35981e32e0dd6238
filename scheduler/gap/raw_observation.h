/// Scalars and curves as a file writes them, each number with its place: what the YAML and the CSV reader hand to the same check.
#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "input/report.h"

namespace regolab::gap {

struct RawNumber {
  double value = NAN;
  std::string written;  ///< for messages
  Place place;
};

struct RawScalar {
  std::string id;
  Place place;        ///< of the entry
  Place id_place;
  RawNumber value;
  std::string unit;
  Place unit_place;
  std::optional<RawNumber> standard_error;  ///< in `unit`
  int seeds = 1;
  std::string definition;
};

struct RawList {
  std::vector<RawNumber> numbers;
  Place place;
};

struct RawCurve {
  std::string id;
  Place place, id_place;
  std::string test;
  std::optional<RawNumber> sigma3;  ///< [Pa]
  std::string x_name, x_unit, y_name, y_unit;
  Place x_unit_place, y_unit_place;
  RawList x, y;
  std::optional<RawList> y_standard_error;
  int seeds = 1;
};

struct RawObservations {
  std::vector<RawScalar> scalars;
  std::vector<RawCurve> curves;
};

}  // namespace regolab::gap
