#include "scheduler/design/factor_block.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "input/suggestion.h"
#include "input/unit_convert.h"

namespace regolab {
namespace {

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const Field& field : all_fields()) names.push_back(field.name);
  return names;
}

bool same_value(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

/// `unit:` of a factor, checked once here rather than at each level.
bool unit_fits(const YamlNode& node, const Field& field, const std::string& path, Report& report) {
  if (!node.is_scalar()) {
    report.add(node.place, path + ".unit is " + std::string(name_of(node.kind)) +
                               " (must be a unit) write e.g. `unit: " + std::string(door_unit_of(field)) + "`");
    return false;
  }
  if (!field.choices.empty()) {
    report.add(node.place,
               path + ".unit: " + std::string(field.what) + " has no unit (its levels are names) remove the unit");
    return false;
  }
  const auto converted = convert_to_si(1, "1 " + node.text, node.text, field.si, field.what);
  if (!converted.ok()) report.add(node.place, path + ".unit: " + converted.error().text);
  return converted.ok();
}

void read_levels(const YamlNode& list, const std::string& path, FactorLevels& factor, Report& report) {
  if (!list.is_list() || list.items.size() < 2 || list.items.size() > kMostLevels) {
    report.add(list.place, path + " needs 2 to " + std::to_string(kMostLevels) +
                               " levels (it is varied) list them, e.g. [a, b], or move it to `fixed`");
    return;
  }
  for (const YamlNode& item : list.items) {
    const auto value = read_field(factor.field, item, factor.unit, path, report);
    if (!value) continue;
    if (level_of(factor, *value)) {
      report.add(item.place, path + ": level " + excerpt(item.text) + " stands twice (levels differ) remove one");
    }
    factor.values.push_back(*value);
  }
  if (factor.values.size() != list.items.size()) factor.values.clear();  // a factor with a wrong level is not used further
}

FactorLevels read_factor(const YamlNode& node, const Field& field, Place place, Report& report) {
  FactorLevels factor{.field = field, .unit = {}, .values = {}, .place = place};
  const std::string path = "factors." + std::string(field.name);
  if (!node.is_map()) {
    read_levels(node, path, factor, report);
    return factor;
  }
  MapReader block(node, path, report);
  const YamlNode* unit = block.get("unit");
  const bool usable = unit == nullptr || unit_fits(*unit, field, path, report);
  if (unit != nullptr && usable) factor.unit = unit->text;
  const YamlNode* levels = block.need("levels", "levels: [a, b]");
  if (levels != nullptr && usable) read_levels(*levels, path, factor, report);
  block.finish();
  return factor;
}

}  // namespace

std::vector<FactorLevels> read_factors(MapReader& top, DampingUnit damping, Report& report) {
  std::vector<FactorLevels> factors;
  const YamlNode* node = top.get("factors");
  if (node == nullptr) return factors;
  MapReader block(*node, "factors", report);
  for (std::size_t i = 0; i < node->keys.size(); ++i) {
    const YamlKey& key = node->keys[i];
    const Field* field = find_field(key.text);
    if (field == nullptr) {
      report.add(key.place, "unknown factor '" + excerpt(key.text) + "' (no parameter has that name) " +
                                suggestion(key.text, field_names()));
      continue;
    }
    if (node->items[i].kind == YamlNode::Kind::kNull) {
      report.add(key.place, "factors." + key.text + " has no levels (the key stands alone) list two or more");
      continue;
    }
    const auto known = [&](const FactorLevels& other) { return other.field.name == field->name; };
    if (std::ranges::any_of(factors, known)) continue;  // a duplicate key, reported by the parser
    factors.push_back(read_factor(node->items[i], under(*field, damping), key.place, report));
  }
  return factors;
}

std::optional<int> level_of(const FactorLevels& factor, double value) {
  for (std::size_t i = 0; i < factor.values.size(); ++i) {
    if (same_value(factor.values[i], value)) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::vector<std::string> labels_of(const FactorLevels& factor) {
  std::vector<std::string> labels;
  for (const double value : factor.values) labels.push_back(door_text(factor.field, value));
  return labels;
}

std::vector<FixedValue> read_fixed(MapReader& fixed, DampingUnit damping, Report& report) {
  std::vector<FixedValue> values;
  for (const Field& shared : all_fields()) {
    if (shared.group != Field::Group::kMicro && shared.group != Field::Group::kMaterial) continue;
    const YamlNode* node = fixed.get(shared.name);
    if (node == nullptr) continue;
    const auto value = read_field(under(shared, damping), *node, "", fixed.path_of(shared.name), report);
    values.push_back({shared.name, value.value_or(NAN), node->place});
  }
  fixed.finish();
  return values;
}

}  // namespace regolab
