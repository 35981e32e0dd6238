/// One value of a field, read from YAML or from a table cell.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "input/field.h"
#include "input/report.h"
#include "input/yaml_tree.h"

namespace regolab {

/// The SI value (or choice number) that `text` says. `bare_unit` is the unit of a number without one; empty = a unit is
/// needed unless the field is a pure number. `path` is what messages call it ("micro.K_N"). All problems go to `report`.
std::optional<double> read_field(const Field& field, std::string_view text, std::string_view bare_unit,
                                 const std::string& path, Place place, Report& report);

/// As above for a YAML value, which must be text.
std::optional<double> read_field(const Field& field, const YamlNode& node, std::string_view bare_unit,
                                 const std::string& path, Report& report);

/// A whole number in [low, high] that is no field (a seed, a column).
std::optional<std::uint64_t> read_whole(const YamlNode& node, std::uint64_t low, std::uint64_t high, const std::string& path,
                                        Report& report);

/// One of `names`, by index; unknown ones are reported with a suggestion.
std::optional<std::size_t> read_name(const YamlNode& node, std::span<const std::string_view> names, const std::string& path,
                                     Report& report);

}  // namespace regolab
