#include "scheduler/gap/csv_table.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "input/number_text.h"
#include "input/suggestion.h"
#include "input/unit_convert.h"
#include "scheduler/gap/observation.h"

namespace regolab::gap {

std::optional<CsvTable> parse_csv(const std::string& text, Report& report) {
  if (text.size() > kLargestObservations) {
    report.add({}, "file of " + std::to_string(text.size()) + " bytes (the limit is " + std::to_string(kLargestObservations) + ") give fewer points");
    return std::nullopt;
  }
  if (const auto bad = first_bad_byte(text)) {
    report.add({}, "not a text file (the byte at offset " + std::to_string(*bad) + " is not UTF-8 text) save the table as CSV in UTF-8");
    return std::nullopt;
  }
  CsvTable table;
  int number = 0;
  for_each_line(text, [&](std::string_view content) {
    ++number;
    if (content.empty()) return;
    auto cells = csv_cells(content);
    if (table.names.empty()) {
      for (const CsvCell& cell : cells) table.names.push_back(cell.text);
    } else {
      table.lines.push_back({number, std::move(cells)});
    }
  });
  if (table.lines.empty()) report.add({}, "no rows (the first line names the columns, the others are measurements) give a table with both");
  return table.lines.empty() ? std::nullopt : std::optional(std::move(table));
}

std::string MapEntry::text(std::string_view key, bool needed) {
  const YamlNode* value = needed ? map_.need(key, key == "id" ? "id: sigma1" : std::string(key) + ": kPa") : map_.get(key);
  return value && value->is_scalar() ? value->text : "";
}

std::optional<std::size_t> MapEntry::column(std::string_view key, bool needed) {
  const YamlNode* value = needed ? map_.need(key, std::string(key) + ": " + (table_.names.empty() ? "1" : table_.names.front())) : map_.get(key);
  return value ? find_column(*value, map_.path_of(key)) : std::nullopt;
}

std::vector<const CsvTable::Line*> MapEntry::matching() {
  std::vector<std::pair<std::size_t, std::string>> wanted;
  if (const YamlNode* where = map_.get("where")) {
    if (!where->is_map()) report_.add(where->place, map_.path_of("where") + " (must be a map of column: cell) write e.g. `where: {test: triaxial}`");
    for (std::size_t k = 0; k < where->keys.size(); ++k) {
      const YamlNode name{.kind = YamlNode::Kind::kScalar, .place = where->keys[k].place, .text = where->keys[k].text};
      if (const auto c = find_column(name, map_.path_of("where"))) wanted.emplace_back(*c, where->items[k].text);
    }
  }
  std::vector<const CsvTable::Line*> out;
  for (const CsvTable::Line& line : table_.lines) {
    const auto fits = [&](const auto& pair) { return pair.first < line.cells.size() && line.cells[pair.first].text == pair.second; };
    if (std::ranges::all_of(wanted, fits)) out.push_back(&line);
  }
  if (out.empty() && report_.empty()) report_.add(node_.place, map_.path_of("where") + " (no row of the CSV fits) compare it with the cells");
  return out;
}

std::optional<RawNumber> MapEntry::cell(const CsvTable::Line& line, std::size_t column) {
  if (column >= line.cells.size() || line.cells[column].text.empty()) return std::nullopt;
  const CsvCell& cell = line.cells[column];
  const auto number = leading_number(cell.text);
  const Place place{line.number, cell.column};
  if (number && number->rest.empty() && std::isfinite(number->value)) return RawNumber{number->value, cell.text, place};
  csv_report_.add(place, "'" + excerpt(cell.text) + "' in column " + excerpt(table_.names[std::min(column, table_.names.size() - 1)]) +
                             " is not a finite number (it is measured) correct it, or leave the cell empty");
  return std::nullopt;
}

std::optional<double> MapEntry::stress_of(std::string_view key) {
  const YamlNode* value = map_.get(key);
  if (!value) return std::nullopt;
  const auto number = value->is_scalar() ? leading_number(value->text) : std::nullopt;
  const auto pascals = number ? convert_to_si(number->value, value->text, number->rest.empty() ? "1" : number->rest, "Pa", "confining stress")
                              : Result<double>(invalid("'" + excerpt(value->text) + "' is not a stress (a number with its unit is needed) write e.g. `5 kPa`"));
  if (pascals.ok() && *pascals > 0) return *pascals;
  report_.add(value->place, map_.path_of(key) + ": " + (pascals.ok() ? "must be above 0 (it confines) correct it" : pascals.error().text));
  return std::nullopt;
}

std::optional<std::size_t> MapEntry::find_column(const YamlNode& node, const std::string& path) {
  const auto named = std::ranges::find(table_.names, node.text);
  if (node.is_scalar() && named != table_.names.end()) return static_cast<std::size_t>(named - table_.names.begin());
  const auto number = node.is_scalar() ? leading_number(node.text) : std::nullopt;
  if (number && number->rest.empty() && number->value >= 1 && number->value <= static_cast<double>(table_.names.size()) && number->value == std::floor(number->value)) {
    return static_cast<std::size_t>(number->value) - 1;
  }
  const std::vector<std::string_view> known(table_.names.begin(), table_.names.end());
  report_.add(node.place, path + ": no column '" + excerpt(node.is_scalar() ? node.text : name_of(node.kind)) + "' (the CSV does not have it) " + suggestion(node.text, known));
  return std::nullopt;
}

}  // namespace regolab::gap
