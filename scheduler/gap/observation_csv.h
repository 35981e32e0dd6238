/// MEASUREMENTS.csv with MAP.yaml (`format: observation-map/1`), which says what stands where.
#pragma once
#include <string>

#include "scheduler/gap/observation_file.h"

namespace regolab::gap {

struct CsvSource {
  std::string map_name, map_text;
  std::string csv_name, csv_text;
};

/// The map has `case`, `material`, `specimen` and `nominal_protocol` as observation files do, and two lists.
///   scalars: - {id: sigma1, column: s1, unit: kPa, sigma3_column: p, sigma3_unit: kPa, where: {test: triaxial}}
///     rows that match `where` and have a number in `column` are repeats (of each sigma3): their mean, and s/sqrt(n) as its error,
///     unless `standard_error_column` (of a single row) or `standard_error` (a number) gives it, in the unit of the value
///   curves: - {id: sigma1, sigma3: 5 kPa, x_column: strain, x_unit: '%', y_column: s1, y_unit: kPa, y_standard_error_column: e}
/// Columns are named by the CSV's first line, or counted from 1. Problems are told at their place in the map or in the CSV.
Read<ObservationSet> read_measurements(const CsvSource& source, MissingErrors missing = MissingErrors::kRefuse);

}  // namespace regolab::gap
