/// TARGET.yaml: what a material should measure, what is given, what may vary.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "input/diagnostic.h"
#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

struct Target {
  std::string response;  ///< bulk_density, ..., or sigma1_at_sigma3_5kPa
  std::string unit;      ///< SI
  double value = 0, tolerance = 0;  ///< [SI]
  double sigma3 = 0;     ///< of a stress target [Pa]; 0 otherwise
};

/// A question to a model: targets, and for each column its range (low == high: fixed) or the choices still open.
struct Question {
  std::string name;
  std::vector<Target> targets;
  struct Span {
    double low = 0, high = 0;
    std::vector<double> choices;
  };
  std::vector<Span> spans;  ///< [n_columns]
};

/// Every problem with its place: unknown keys and properties, units, targets that contradict each other, a parameter that the model
/// does not have, a range outside the model's.
Read<Question> read_target(const std::string& file_name, const std::string& text, const Model& model);

}  // namespace regolab::surrogate
