/// Scalars and curves in SI by id: what features are made of, whoever measured them.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/gap/observation.h"
#include "vocab/measurement.h"

namespace regolab::gap {

struct Reading {
  double value = 0;
  double standard_error = 0;  ///< 0 for a single run of ours: its scatter shows between seeds
  int repeats = 1;
  bool assumed = false;
};

struct CurveReading {
  std::vector<double> x, y, y_standard_error;  // [n_points]; errors empty for a run of ours
  int repeats = 1;
  bool assumed = false;
};

struct Readings {
  std::map<std::string, Reading> scalars;     ///< by id in normal form
  std::map<std::string, CurveReading> curves;
};

Readings readings_of(const ObservationSet& set);

/// Adds what a stage of ours measured. What a run says about its own scatter is left out (see Reading::standard_error).
void add_readings(const StageResult& result, Readings& readings);

}  // namespace regolab::gap
