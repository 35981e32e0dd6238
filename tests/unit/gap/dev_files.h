/// Five observation files made with an independent code (LAMMPS), and small ones to spoil.
#pragma once
#include <string>

#include "scheduler/gap/observation_file.h"
#include "support/diagnostics.h"

namespace regolab::gap {

inline constexpr const char* kDevFiles[] = {"dev-01", "dev-02", "dev-03", "dev-04", "dev-05"};

inline std::string dev_text(const std::string& name) { return testing_support::read_file(REGOLAB_SOURCE "/tests/unit/gap/data/" + name + ".yaml"); }

inline ObservationSet dev_set(const std::string& name) {
  auto read = read_observations(name, dev_text(name));
  for (const Diagnostic& d : read.diagnostics) ADD_FAILURE() << to_text(d);
  return read.value.value_or(ObservationSet{});
}

/// A file with one observable, in lines 3 to 7: id, value, unit, standard_error, seeds.
inline std::string one_observable(const std::string& id, const std::string& value, const std::string& unit, const std::string& error) {
  return "format: observations/1\ncase: small\nobservables:\n- id: " + id + "\n  value: " + value + "\n  unit: " + unit + "\n  standard_error: " + error + "\n  seeds: 3\n";
}

/// The same with one curve, in lines 4 to 11.
inline std::string one_curve(const std::string& x, const std::string& y, const std::string& error) {
  return "format: observations/1\ncase: small\ncurves:\n- id: sigma1_at_sigma3_5kPa\n  test: stress\n  sigma3_kPa: 5\n  x_unit: '1'\n  x: " + x +
         "\n  y_unit: kPa\n  y: " + y + "\n  y_standard_error: " + error + "\n";
}

}  // namespace regolab::gap
