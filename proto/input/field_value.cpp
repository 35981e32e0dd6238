#include "input/field_value.h"

#include <cmath>
#include <limits>
#include <vector>

#include "input/number_text.h"
#include "input/suggestion.h"
#include "input/unit_convert.h"

namespace regolab {
namespace {

constexpr double kSlack = 1e-12;  // a limit given exactly must pass whatever unit it came in

bool in_range(const Field& field, double value) {
  if (field.zero_too && value == 0) return true;
  const double slack = kSlack * std::max(std::abs(field.low), std::abs(field.high));
  return value >= field.low - std::min(slack, std::abs(field.low) * 1e-9) && value <= field.high + slack;
}

std::optional<double> read_choice(const Field& field, std::string_view text, const std::string& path, Place place,
                                  Report& report) {
  std::vector<std::string_view> names;
  for (const Choice& choice : field.choices) {
    if (text == choice.name || text == choice.alias) return choice.value;
    names.push_back(choice.name);
  }
  report.add(place, path + ": '" + excerpt(text) + "' is no " + std::string(field.what) + " (" + std::string(field.usual) +
                        ") choose one of " + join_names(names));
  return std::nullopt;
}

std::string missing_unit(const Field& field, std::string_view text, const std::string& path) {
  const std::string shown = excerpt(text);
  return path + ": " + shown + " has no unit (a " + std::string(field.what) + " needs one) write e.g. `" + shown + " " +
         std::string(door_unit_of(field)) + "`";
}

std::string field_example(const Field& field) { return std::string(field.example.empty() ? field.usual : field.example); }

/// Number and unit to SI, with every slip told; range not checked yet.
std::optional<double> read_quantity(const Field& field, std::string_view text, std::string_view bare_unit,
                                    const std::string& path, Place place, Report& report) {
  const auto number = leading_number(text);
  if (!number) {
    report.add(place, path + ": '" + excerpt(text) + "' is not a number (a " + std::string(field.what) +
                          " is needed) write one " + range_text(field));
    return std::nullopt;
  }
  if (!std::isfinite(number->value)) {
    report.add(place, path + ": " + excerpt(text) + " is not a finite number (nothing can be computed from it) write one " +
                          range_text(field));
    return std::nullopt;
  }
  if (number->rest.starts_with(',')) {
    report.add(place, path + ": '" + excerpt(text) + "' has a comma (decimals take a point here) write e.g. 1.5");
    return std::nullopt;
  }
  const bool pure = field.si == "1";
  std::string_view unit = number->rest;
  if (unit.empty()) unit = bare_unit.empty() && pure ? "1" : bare_unit;
  if (unit.empty()) {
    report.add(place, missing_unit(field, text, path));
    return std::nullopt;
  }
  if (pure && unit == "1") return number->value;  // no conversion, no database
  const auto si = convert_to_si(number->value, text, unit, field.si, field.what);
  if (si.ok()) return *si;
  report.add(place, path + ": " + si.error().text);
  return std::nullopt;
}

}  // namespace

std::optional<double> read_field(const Field& field, std::string_view text, std::string_view bare_unit,
                                 const std::string& path, Place place, Report& report) {
  if (!field.choices.empty()) return read_choice(field, text, path, place, report);
  const auto value = read_quantity(field, text, bare_unit, path, place, report);
  if (!value) return std::nullopt;
  if (field.whole && *value != std::floor(*value)) {
    report.add(place, path + ": " + excerpt(text) + " (must be a whole number) write one " + range_text(field));
    return std::nullopt;
  }
  if (!in_range(field, *value)) {
    report.add(place, path + ": " + excerpt(text) + " (must be " + range_text(field) + ") " + std::string(field.usual));
    return std::nullopt;
  }
  return value;
}

std::optional<double> read_field(const Field& field, const YamlNode& node, std::string_view bare_unit,
                                 const std::string& path, Report& report) {
  if (node.is_scalar()) return read_field(field, node.text, bare_unit, path, node.place, report);
  report.add(node.place,
             path + " is " + std::string(name_of(node.kind)) + " (must be one value) write `" + field_example(field) + "`");
  return std::nullopt;
}

std::optional<std::uint64_t> read_whole(const YamlNode& node, std::uint64_t low, std::uint64_t high, const std::string& path,
                                        Report& report) {
  const std::string wanted = " (must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                             ") write e.g. " + std::to_string(std::max<std::uint64_t>(low, 1));
  const auto number = node.is_scalar() ? leading_number(node.text) : std::nullopt;
  const bool whole =
      number && number->rest.empty() && std::isfinite(number->value) && number->value == std::floor(number->value);
  if (!whole || number->value < static_cast<double>(low) || number->value > static_cast<double>(high)) {
    report.add(node.place, path + ": " + (node.is_scalar() ? excerpt(node.text) : std::string(name_of(node.kind))) + wanted);
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(number->value);
}

std::optional<std::size_t> read_name(const YamlNode& node, std::span<const std::string_view> names, const std::string& path,
                                     Report& report) {
  if (!node.is_scalar()) {
    report.add(node.place,
               path + " is " + std::string(name_of(node.kind)) + " (must be a name) choose one of " + join_names(names));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (node.text == names[i]) return i;
  }
  report.add(node.place, path + ": unknown name '" + excerpt(node.text) + "' (it must be one of those known) " +
                             suggestion(node.text, names));
  return std::nullopt;
}

}  // namespace regolab
