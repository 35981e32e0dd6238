#include "scheduler/gap/observation_csv.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "input/field_value.h"
#include "input/map_reader.h"
#include "input/number_text.h"
#include "input/unit_convert.h"
#include "scheduler/gap/condition_blocks.h"
#include "scheduler/gap/csv_table.h"
#include "scheduler/gap/observation_check.h"
#include "scheduler/gap/observation_end.h"
#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

/// The mean of repeats and its standard error, which one alone does not have.
RawScalar mean_of(const std::vector<RawNumber>& repeats) {
  RawScalar raw;
  const double n = static_cast<double>(repeats.size());
  double sum = 0, squares = 0;
  for (const RawNumber& r : repeats) sum += r.value;
  for (const RawNumber& r : repeats) squares += (r.value - sum / n) * (r.value - sum / n);
  raw.value = repeats.front();
  raw.value.value = sum / n;
  raw.seeds = static_cast<int>(repeats.size());
  if (repeats.size() > 1) raw.standard_error = RawNumber{std::sqrt(squares / (n - 1) / n), "s/sqrt(n)", repeats.front().place};
  return raw;
}

class Importer {
 public:
  Importer(const CsvTable& table, Report& map_report, Report& csv_report) : table_(table), report_(map_report), csv_report_(csv_report) {}

  void scalar(const YamlNode& node, const std::string& path, RawObservations& out) {
    MapEntry entry(node, path, table_, report_, csv_report_);
    const std::string id = entry.text("id", true), unit = entry.text("unit", true), definition = entry.text("definition");
    const auto column = entry.column("column", true), error_column = entry.column("standard_error_column", false), stress_column = entry.column("sigma3_column", false);
    const auto stress = entry.stress_of("sigma3");
    const std::string stress_unit = entry.text("sigma3_unit");
    const YamlNode* error = entry.map().get("standard_error");
    const auto lines = entry.matching();
    entry.map().finish();
    if (stress_column && stress_unit.empty()) report_.add(node.place, path + ": sigma3_column without sigma3_unit (its numbers have none) add e.g. `sigma3_unit: kPa`");
    if (!report_.empty() || !column) return;
    std::map<double, std::vector<RawNumber>> repeats;  // by sigma3 [Pa]
    std::map<double, RawNumber> errors;
    for (const CsvTable::Line* line : lines) {
      const auto value = entry.cell(*line, *column);
      const auto sigma3 = stress_column ? stress_in(entry, *line, *stress_column, stress_unit) : stress.value_or(0);
      if (!value || !sigma3) continue;
      repeats[*sigma3].push_back(*value);
      if (error_column) {
        if (const auto e = entry.cell(*line, *error_column)) errors[*sigma3] = *e;
      }
    }
    if (repeats.empty() && csv_report_.empty()) report_.add(node.place, path + ": no numbers in its column (every cell that fits is empty) compare `column` and `where` with the CSV");
    for (const auto& [sigma3, numbers] : repeats) {
      RawScalar raw = mean_of(numbers);
      raw.id = id_of(id, sigma3);
      raw.unit = unit, raw.definition = definition;
      raw.place = raw.id_place = raw.unit_place = raw.value.place;
      given_error(entry, numbers, errors.contains(sigma3) ? &errors.at(sigma3) : nullptr, error, raw);
      out.scalars.push_back(std::move(raw));
    }
  }

  void curve(const YamlNode& node, const std::string& path, RawObservations& out) {
    MapEntry entry(node, path, table_, report_, csv_report_);
    RawCurve raw;
    raw.id = entry.text("id", true);
    raw.x_unit = entry.text("x_unit", true), raw.y_unit = entry.text("y_unit", true);
    raw.x_name = entry.text("x_name"), raw.y_name = entry.text("y_name"), raw.test = entry.text("test");
    const auto x = entry.column("x_column", true), y = entry.column("y_column", true), e = entry.column("y_standard_error_column", false);
    const auto stress = entry.stress_of("sigma3");
    if (const YamlNode* seeds = entry.map().get("seeds")) raw.seeds = static_cast<int>(read_whole(*seeds, 1, 1000000, path + ".seeds", report_).value_or(1));
    const auto lines = entry.matching();
    entry.map().finish();
    if (!report_.empty() || !x || !y || lines.empty()) return;
    raw.place = raw.id_place = raw.x_unit_place = raw.y_unit_place = {lines.front()->number, 1};
    raw.x.place = raw.y.place = raw.place;
    if (stress) raw.sigma3 = RawNumber{*stress, kilopascals(*stress) + " kPa", raw.place};
    if (e) raw.y_standard_error = RawList{.numbers = {}, .place = raw.place};
    for (const CsvTable::Line* line : lines) {
      const auto xv = entry.cell(*line, *x), yv = entry.cell(*line, *y);
      if (!xv && !yv) continue;  // columns of other curves may be longer
      if (xv) raw.x.numbers.push_back(*xv);
      if (yv) raw.y.numbers.push_back(*yv);
      if (!e) continue;
      if (const auto ev = entry.cell(*line, *e)) raw.y_standard_error->numbers.push_back(*ev);
    }
    out.curves.push_back(std::move(raw));
  }

 private:
  std::optional<double> stress_in(MapEntry& entry, const CsvTable::Line& line, std::size_t column, const std::string& unit) {
    const auto number = entry.cell(line, column);
    if (!number) return std::nullopt;
    const auto pascals = convert_to_si(number->value, number->written + " " + unit, unit, "Pa", "confining stress");
    if (pascals.ok() && *pascals > 0) return *pascals;
    csv_report_.add(number->place, "sigma3: " + (pascals.ok() ? excerpt(number->written) + " (must be above 0) correct it" : pascals.error().text));
    return std::nullopt;
  }

  static std::string id_of(const std::string& id, double sigma3) {
    if (!(sigma3 > 0)) return id;
    const auto known = scalar_id(id, sigma3);
    return known ? known->normal : id + "_at_sigma3_" + kilopascals(sigma3) + "kPa";
  }

  /// An error in a column or in the map is louder than the scatter of repeats.
  void given_error(MapEntry& entry, const std::vector<RawNumber>& numbers, const RawNumber* in_column, const YamlNode* in_map, RawScalar& raw) {
    if (in_column && numbers.size() > 1) {
      csv_report_.add(in_column->place, raw.id + ": " + std::to_string(numbers.size()) + " rows, each with its error (one row is a mean with an error, several are repeats) give one, or leave standard_error_column out");
    } else if (in_column) {
      raw.standard_error = *in_column;
    } else if (in_map) {
      const auto number = in_map->is_scalar() ? leading_number(in_map->text) : std::nullopt;
      if (number && number->rest.empty() && std::isfinite(number->value) && number->value >= 0) raw.standard_error = RawNumber{number->value, in_map->text, raw.place};
      else report_.add(in_map->place, entry.map().path_of("standard_error") + ": '" + excerpt(in_map->text) + "' (must be a number from 0, in the unit of the value) correct it");
    }
  }

  const CsvTable& table_;
  Report& report_;
  Report& csv_report_;
};

std::optional<ObservationSet> read(const YamlNode& root, const CsvTable& table, MissingErrors missing, Report& report, Report& csv_report, Report& warnings) {
  MapReader top(root, "", report);
  const YamlNode* format = top.need("format", "format: observation-map/1");
  if (format && format->text != "observation-map/1") {
    report.add(format->place, "format: " + excerpt(format->text) + " (a map is observation-map/1) write `format: observation-map/1`");
    return std::nullopt;
  }
  ObservationSet set;
  if (const YamlNode* name = top.need("case", "case: jsc-1"); name && name->is_scalar()) set.name = excerpt(name->text);
  read_conditions(top, set, report);
  const YamlNode *scalars = top.get("scalars"), *curves = top.get("curves");
  top.finish();
  RawObservations raw;
  Importer importer(table, report, csv_report);
  for (const auto& [list, name] : {std::pair{scalars, "scalars"}, {curves, "curves"}}) {
    if (list && !list->is_list()) report.add(list->place, std::string(name) + " (must be a list) write `- {id: ..., column: ...}`");
    for (std::size_t i = 0; list && list->is_list() && i < list->items.size(); ++i) {
      const std::string path = std::string(name) + "[" + std::to_string(i + 1) + "]";
      list == scalars ? importer.scalar(list->items[i], path, raw) : importer.curve(list->items[i], path, raw);
    }
  }
  check_observations(raw, missing, set, csv_report, warnings);
  return set;
}

}  // namespace

Read<ObservationSet> read_measurements(const CsvSource& source, MissingErrors missing) {
  Report report(source.map_name, source.map_text.size() > kLargestFile ? "" : source.map_text);
  const std::string_view lines = source.csv_text.size() > kLargestObservations ? std::string_view() : source.csv_text;
  Report csv_report(source.csv_name, lines), warnings(source.csv_name, lines);
  const auto root = parse_yaml(source.map_text, report);
  const auto table = parse_csv(source.csv_text, csv_report);
  std::optional<ObservationSet> set;
  if (root && table) set = read(*root, *table, missing, report, csv_report, warnings);
  auto first = report.take();
  auto out = finished(first.empty() ? std::move(set) : std::nullopt, csv_report, warnings);
  if (first.empty()) return out;
  out.value.reset();
  out.diagnostics.insert(out.diagnostics.begin(), first.begin(), first.end());
  return out;
}

}  // namespace regolab::gap
