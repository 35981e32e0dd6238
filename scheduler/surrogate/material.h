/// A material as people write it, read into the inputs of a surrogate.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

struct Material {
  std::vector<double> x;             ///< [n_columns]
  std::vector<std::string> assumed;  ///< "gravity = 1.63 m/s2": not given, and it has a usual value
  std::vector<std::string> outside;  ///< what lies outside the data
};

/// `set`: theta_F -> "40 degree". Errors: kInvalidArgument, all problems in one text (unknown, missing, unreadable parameters).
Result<Material> read_material(const Model& model, const std::map<std::string, std::string>& set);

/// An input as a person writes it: "40 deg", "mixture".
std::string input_text(const InputColumn& column, double value);
/// Door unit of an input; "1" for choices and pure numbers.
std::string input_unit(const InputColumn& column);
/// Shown = SI value times this.
double input_factor(const InputColumn& column);

}  // namespace regolab::surrogate
