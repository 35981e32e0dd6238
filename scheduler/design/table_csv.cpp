#include "scheduler/design/table_csv.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "input/field_value.h"
#include "input/suggestion.h"
#include "input/yaml_tree.h"
#include "scheduler/design/array_choice.h"

namespace regolab {
namespace {

struct Cell {
  std::string text;
  Place place;
};
using Line = std::vector<Cell>;

struct Column {
  std::size_t cell = 0;  ///< where it stands in a line
  FactorLevels factor;
  std::vector<double> values;  // [n_rows] SI
};

std::string trimmed(std::string_view text) {
  const auto is_padding = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && is_padding(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  return std::string(text);
}

Line split_cells(std::string_view text, int line) {
  Line cells;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    cells.push_back({trimmed(text.substr(start, comma - start)), {line, static_cast<int>(start) + 1}});
    start = comma + 1;
  }
  return cells;
}

/// Lines that hold something; `#` starts a comment line.
std::vector<Line> split_table(std::string_view csv) {
  if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);
  std::vector<Line> lines;
  for (int number = 1; !csv.empty(); ++number) {
    const std::size_t end = std::min(csv.find('\n'), csv.size());
    const std::string_view text = csv.substr(0, end);
    if (const std::string kept = trimmed(text); !kept.empty() && kept.front() != '#')
      lines.push_back(split_cells(text, number));
    csv.remove_prefix(std::min(end + 1, csv.size()));
  }
  return lines;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

struct Heading {
  const Field* field = nullptr;
  std::string unit;
};

/// "K_N_N_per_m" -> K_N, "N/m"; "K_N (N/m)" likewise; "N_E" -> N_E, "".
Heading parse_heading(const std::string& text) {
  Heading heading;
  for (const Field& field : all_fields()) {  // the longest name that fits: L_S is no prefix trouble, K_N of K_N_... is
    const bool prefix =
        text.starts_with(field.name) && (text.size() == field.name.size() ||
                                         std::string_view(" ([_").find(text[field.name.size()]) != std::string_view::npos);
    if (prefix && (heading.field == nullptr || field.name.size() > heading.field->name.size())) heading.field = &field;
  }
  if (heading.field == nullptr) return heading;
  std::string unit = text.substr(heading.field->name.size());
  if (unit.starts_with('_')) {
    replace_all(unit, "_per_", "/");
    replace_all(unit, "_", " ");
  }
  std::erase_if(unit, [](char c) { return c == '(' || c == ')' || c == '[' || c == ']'; });
  heading.unit = trimmed(unit);
  return heading;
}

std::vector<std::string_view> names_of(std::span<const Field> fields) {
  std::vector<std::string_view> names;
  for (const Field& field : fields) names.push_back(field.name);
  return names;
}

std::vector<Column> read_headings(const Line& line, DampingUnit damping, const std::vector<FactorLevels>& factors,
                                  Report& report) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Cell& cell = line[i];
    if (i == 0 && (cell.text == "point" || cell.text == "test")) continue;
    const Heading heading = parse_heading(cell.text);
    if (heading.field == nullptr) {
      report.add(cell.place, "unknown column '" + excerpt(cell.text) +
                                 "' (a column is a factor with its unit, e.g. K_N_N_per_m or `K_N (N/m)`) " +
                                 suggestion(cell.text, names_of(all_fields())));
      continue;
    }
    const auto same = [&](const auto& other) { return other.factor.field.name == heading.field->name; };
    if (std::ranges::any_of(columns, same)) {
      report.add(cell.place, "duplicate column '" + excerpt(cell.text) + "' (each factor has one) remove it");
      continue;
    }
    FactorLevels factor{.field = under(*heading.field, damping), .unit = heading.unit, .values = {}, .place = cell.place};
    const auto given = std::ranges::find(factors, heading.field->name, [](const FactorLevels& f) { return f.field.name; });
    if (given != factors.end()) factor.values = given->values;
    if (given == factors.end() && !factors.empty()) {
      report.add(cell.place,
                 "column '" + excerpt(cell.text) +
                     "' is no factor of the design (`factors` lists others) add it there, or leave `factors` out");
    }
    columns.push_back({.cell = i, .factor = std::move(factor), .values = {}});
  }
  for (const FactorLevels& factor : factors) {
    const auto same = [&](const Column& column) { return column.factor.field.name == factor.field.name; };
    if (std::ranges::none_of(columns, same)) {
      report.add(line.front().place,
                 "missing column '" + std::string(factor.field.name) + "' (it is a factor of the design) add it");
    }
  }
  return columns;
}

void read_row(const Line& line, std::size_t row, std::size_t width, bool counted, std::vector<Column>& columns,
              Report& report) {
  if (line.size() != width) {
    report.add(line.front().place, "row has " + std::to_string(line.size()) + " cells (the header has " +
                                       std::to_string(width) + ") complete it, or remove what is too much");
    return;
  }
  if (counted && line.front().text != std::to_string(row + 1)) {
    report.add(line.front().place,
               "point '" + excerpt(line.front().text) + "' (points count 1, 2, 3, ...) write " + std::to_string(row + 1));
  }
  for (Column& column : columns) {
    const Cell& cell = line[column.cell];
    const std::string path = "row " + std::to_string(row + 1) + ", " + std::string(column.factor.field.name);
    const auto value = read_field(column.factor.field, cell.text, column.factor.unit, path, cell.place, report);
    column.values.push_back(value.value_or(NAN));
    if (value && !column.factor.values.empty() && !level_of(column.factor, *value)) {
      report.add(cell.place,
                 path + ": " + excerpt(cell.text) + " is no level of it (`factors` lists the levels) use one of those");
    }
  }
}

/// Levels of a factor that `factors:` did not list: its distinct values, ascending.
void derive_levels(Column& column, Report& report) {
  if (!column.factor.values.empty()) return;
  std::vector<double> sorted = column.values;
  std::ranges::sort(sorted);
  for (const double value : sorted) {
    if (!level_of(column.factor, value)) column.factor.values.push_back(value);
  }
  if (column.factor.values.size() < 2 && column.values.size() > 1) {  // one row is one material
    report.add(column.factor.place, "column '" + std::string(column.factor.field.name) + "' has the same value in every row (a factor "
                                        "has two levels or more) put it under `fixed` instead");
  }
}

}  // namespace

std::vector<std::vector<int>> read_table(std::string_view csv, DampingUnit damping, std::vector<FactorLevels>& factors,
                                         Report& report) {
  if (const auto bad = first_bad_byte(csv)) {
    report.add({}, "not a text file (byte at offset " + std::to_string(*bad) + " is not UTF-8 text) give a CSV file");
    return {};
  }
  const std::vector<Line> lines = split_table(csv);
  if (lines.size() < 2 || lines.size() > kMostPoints + 1) {
    report.add({}, "table has " + std::to_string(lines.empty() ? 0 : lines.size() - 1) +
                       " rows below its header (a table has 1 to " + std::to_string(kMostPoints) + ") add or remove rows");
    return {};
  }
  std::vector<Column> columns = read_headings(lines.front(), damping, factors, report);
  const bool counted = lines.front().front().text == "point" || lines.front().front().text == "test";
  for (std::size_t row = 1; row < lines.size(); ++row)
    read_row(lines[row], row - 1, lines.front().size(), counted, columns, report);
  if (!report.empty()) return {};
  for (Column& column : columns) derive_levels(column, report);
  std::vector<std::vector<int>> rows(lines.size() - 1);
  factors.clear();
  for (const Column& column : columns) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      rows[row].push_back(level_of(column.factor, column.values[row]).value_or(0));
    factors.push_back(column.factor);
  }
  return rows;
}

}  // namespace regolab
