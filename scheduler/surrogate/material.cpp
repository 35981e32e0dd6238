#include "scheduler/surrogate/material.h"

#include <algorithm>
#include <cmath>

#include "input/field.h"
#include "input/report.h"
#include "input/suggestion.h"
#include "vocab/units.h"

namespace regolab::surrogate {
namespace {

/// What the article's study uses where its functions leave a parameter out.
const std::map<std::string, std::string>& usual() {
  static const std::map<std::string, std::string> all{{"rotation", "xz"}, {"gravity", "1.63 m/s2"}, {"profile", "quick"}, {"particles", "300"},
                                                      {"particle_density", "2.93 g/cm3"}};
  return all;
}

std::vector<std::string_view> names_of(const Model& model) {
  std::vector<std::string_view> names;
  for (const InputColumn& column : model.data.columns) names.push_back(column.name);
  return names;
}

/// "'30 deg'": what could be written.
std::string example_of(const InputColumn& column) {
  if (column.is_choice()) return column.labels.front();
  const double factor = input_factor(column), middle = 0.5 * (column.low + column.high) * factor;
  const double unit = std::pow(10, 1 - std::floor(std::log10(std::abs(middle))));  // two digits
  return "'" + input_text(column, std::round(middle * unit) / unit / factor) + "'";
}

/// A parameter that the data keep fixed may be given if it says the same.
void check_fixed(const std::string& name, const std::string& text, const Model& model, std::vector<std::string>& problems,
                 std::vector<std::string>& outside) {
  const auto fixed = model.data.fixed.find(name);
  if (fixed == model.data.fixed.end()) {
    const auto names = names_of(model);
    problems.push_back("unknown parameter '" + excerpt(name) + "' (the model has " + [&] {
      std::string list;
      for (const auto known : names) list += (list.empty() ? "" : ", ") + std::string(known);
      return list;
    }() + ") " + suggestion(name, names));
    return;
  }
  const auto given = input_value(name, text), kept = input_value(name, fixed->second);
  if (!given.ok()) problems.push_back(given.error().text);
  else if (kept.ok() && std::abs(*given - *kept) > 1e-9 * std::abs(*kept)) outside.push_back(name + " = " + excerpt(text) + " (all data have " + fixed->second + ")");
}

}  // namespace

std::string input_unit(const InputColumn& column) {
  const Field* field = find_field(column.name);
  return column.is_choice() || !field ? "1" : std::string(door_unit_of(*field));
}

double input_factor(const InputColumn& column) {
  const Field* field = find_field(column.name);
  return column.is_choice() || !field ? 1 : door_unit(field->si).factor;
}

std::string input_text(const InputColumn& column, double value) {
  if (column.is_choice()) return column.labels[static_cast<std::size_t>(value)];
  const std::string unit = input_unit(column);
  return door_text(*find_field(column.name), value) + (unit == "1" ? "" : " " + unit);
}

Result<Material> read_material(const Model& model, const std::map<std::string, std::string>& set) {
  Material material;
  std::vector<std::string> problems, beyond;
  for (const auto& [name, text] : set) {
    if (std::ranges::find(model.data.columns, name, &InputColumn::name) == model.data.columns.end()) {
      check_fixed(name, text, model, problems, beyond);
    }
  }
  for (const InputColumn& column : model.data.columns) {
    auto given = set.find(column.name);
    const auto by_habit = usual().find(column.name);
    if (given == set.end() && by_habit == usual().end()) {
      problems.push_back("missing " + column.name + " (the model needs it) add --set " + column.name + "=" +
                         example_of(column));
      continue;
    }
    const std::string& text = given == set.end() ? by_habit->second : given->second;
    const auto value = input_value(column.name, text);
    if (!value.ok()) {
      problems.push_back(value.error().text);
      continue;
    }
    material.x.push_back(*value);
    if (given == set.end()) material.assumed.push_back(column.name + " = " + text);
  }
  if (!problems.empty()) {
    std::string text;
    for (const std::string& problem : problems) text += (text.empty() ? "" : "; ") + problem;
    return invalid(text);
  }
  material.outside = model.outside(material.x);
  material.outside.insert(material.outside.end(), beyond.begin(), beyond.end());
  return material;
}

}  // namespace regolab::surrogate
