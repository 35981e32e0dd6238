#include "scheduler/design/array_block.h"

#include <algorithm>

#include "input/field_value.h"
#include "input/suggestion.h"
#include "scheduler/design/array_choice.h"
#include "scheduler/design/array_quality.h"
#include "scheduler/design/table_csv.h"

namespace regolab {
namespace {

std::vector<int> level_counts(const std::vector<FactorLevels>& factors) {
  std::vector<int> levels;
  for (const FactorLevels& factor : factors) levels.push_back(static_cast<int>(factor.values.size()));
  return levels;
}

bool all_readable(const std::vector<FactorLevels>& factors) {
  return std::ranges::all_of(factors, [](const FactorLevels& factor) { return factor.values.size() >= 2; });
}

std::string counts_text(const std::vector<FactorLevels>& factors) {
  std::string text;
  for (const FactorLevels& factor : factors) {
    text += (text.empty() ? "" : ", ") + std::string(factor.field.name) + " " + std::to_string(factor.values.size());
  }
  return text;
}

ArrayRows built_in(const std::string& wanted, Place place, const std::vector<FactorLevels>& factors, Report& report) {
  auto chosen = choose_array(wanted, level_counts(factors));
  if (chosen.ok()) return {std::move(chosen->name), std::move(chosen->column), std::move(chosen->rows)};
  report.add(place, "array: " + chosen.error().text + "; levels given: " + counts_text(factors));
  return {};
}

/// One row of level values, in the order of the factors.
std::vector<int> read_row(const YamlNode& node, std::size_t number, const std::vector<FactorLevels>& factors,
                          Report& report) {
  std::vector<int> row;
  const std::string path = "array.rows, row " + std::to_string(number);
  if (!node.is_list() || node.items.size() != factors.size()) {
    report.add(node.place,
               path + " (must list " + std::to_string(factors.size()) + " values, one per factor) " + counts_text(factors));
    return row;
  }
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const FactorLevels& factor = factors[i];
    const std::string name = path + ", " + std::string(factor.field.name);
    const auto value = read_field(factor.field, node.items[i], factor.unit, name, report);
    if (!value) continue;
    const auto level = level_of(factor, *value);
    if (!level)
      report.add(node.items[i].place,
                 name + ": " + excerpt(node.items[i].text) + " is no level of it (`factors` lists them) use one of those");
    row.push_back(level.value_or(0));
  }
  return row;
}

std::vector<std::vector<int>> read_rows(const YamlNode& node, const std::vector<FactorLevels>& factors, Report& report) {
  if (!node.is_list() || node.items.size() < 2 || node.items.size() > kMostPoints) {
    report.add(node.place,
               "array.rows (must be a list of 2 to " + std::to_string(kMostPoints) + " rows) write one row per point");
    return {};
  }
  if (factors.empty()) {
    report.add(node.place, "array.rows without factors (the rows' columns are the factors in their order) add `factors`");
    return {};
  }
  if (!all_readable(factors)) return {};  // said where the factors are
  const std::size_t before = report.size();
  std::vector<std::vector<int>> rows;
  for (const YamlNode& item : node.items) rows.push_back(read_row(item, rows.size() + 1, factors, report));
  return report.size() == before ? rows : std::vector<std::vector<int>>{};
}

std::vector<std::vector<int>> attached_table(const YamlNode& node, DampingUnit damping,
                                             const std::map<std::string, std::string>& attachments,
                                             std::vector<FactorLevels>& factors, Report& report,
                                             std::vector<Diagnostic>& elsewhere) {
  const auto file = node.is_scalar() ? attachments.find(node.text) : attachments.end();
  if (file == attachments.end()) {
    report.add(node.place, "array.table: '" + excerpt(node.text) +
                               "' did not come with the design (the file was not found beside it) check the name");
    return {};
  }
  Report csv(file->first, file->second);
  auto rows = read_table(file->second, damping, factors, csv);
  if (csv.empty()) return rows;
  for (Diagnostic& diagnostic : csv.take()) elsewhere.push_back(std::move(diagnostic));
  return {};
}

/// Rows that call themselves L32 must have 32 runs and every pair of columns balanced.
void check_claim(const YamlNode& name, const std::vector<std::vector<int>>& rows, const std::vector<FactorLevels>& factors,
                 Report& report) {
  const std::string claim = "L" + std::to_string(rows.size());
  if (name.text != claim) {
    report.add(name.place, "array.name: '" + excerpt(name.text) + "' (the rows given are " + std::to_string(rows.size()) +
                               ") write " + claim + ", or leave the name out");
    return;
  }
  if (const auto pair = unbalanced_pair(level_counts(factors), rows)) {
    report.add(name.place, "array.name: the rows are no " + claim + " (" + std::string(factors[pair->first].field.name) +
                               " and " + std::string(factors[pair->second].field.name) +
                               " do not hold every pair of levels equally often) check their values, or leave the name out");
  }
}

ArrayRows explicit_rows(const YamlNode& node, DampingUnit damping, const std::map<std::string, std::string>& attachments,
                        std::vector<FactorLevels>& factors, Report& report, std::vector<Diagnostic>& elsewhere) {
  MapReader block(node, "array", report);
  const YamlNode* name = block.get("name");
  const YamlNode* rows = block.get("rows");
  const YamlNode* table = block.get("table");
  block.finish();
  if (name != nullptr && !name->is_scalar()) {
    report.add(name->place,
               "array.name is " + std::string(name_of(name->kind)) + " (must be a name) write e.g. `name: L32`");
    return {};
  }
  if (rows != nullptr && table != nullptr) {
    report.add(table->place, "array has rows and a table (one of them says what the points are) keep one");
    return {};
  }
  if (rows == nullptr && table == nullptr) {
    if (name != nullptr) return built_in(name->text, name->place, factors, report);
    report.add(node.place, "array says nothing (it must have a name, rows or a table) write e.g. `array: auto`");
    return {};
  }
  ArrayRows read;
  read.rows = rows != nullptr ? read_rows(*rows, factors, report)
                              : attached_table(*table, damping, attachments, factors, report, elsewhere);
  if (read.rows.empty()) return read;
  read.column.assign(factors.size(), 0);
  if (name != nullptr) check_claim(*name, read.rows, factors, report);
  read.name = (name != nullptr ? name->text + ", rows as given (" : "table (") + level_formula(level_counts(factors)) + ")";
  return read;
}

}  // namespace

ArrayRows read_array(MapReader& top, DampingUnit damping, const std::map<std::string, std::string>& attachments,
                     std::vector<FactorLevels>& factors, Report& report, std::vector<Diagnostic>& elsewhere) {
  const YamlNode* node = top.get("array");
  if (node != nullptr && node->is_map()) return explicit_rows(*node, damping, attachments, factors, report, elsewhere);
  if (node != nullptr && !node->is_scalar()) {
    report.add(node->place,
               "array is " + std::string(name_of(node->kind)) + " (must be a name or a map) write e.g. `array: auto`");
    return {};
  }
  if (factors.empty() || !all_readable(factors)) return {};  // said where the factors are
  return built_in(node != nullptr ? node->text : "auto", node != nullptr ? node->place : top.node().place, factors, report);
}

}  // namespace regolab
