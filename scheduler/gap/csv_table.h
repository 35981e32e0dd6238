/// A laboratory's table, and what one entry of its map says of it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "input/map_reader.h"
#include "scheduler/gap/csv_lines.h"
#include "scheduler/gap/raw_observation.h"

namespace regolab::gap {

struct CsvTable {
  std::vector<std::string> names;
  struct Line {
    int number = 0;
    std::vector<CsvCell> cells;
  };
  std::vector<Line> lines;
};

/// Nothing, and a message, for what is too large, no text, or has no rows.
std::optional<CsvTable> parse_csv(const std::string& text, Report& report);

/// One entry of `scalars` or `curves` in the map.
class MapEntry {
 public:
  MapEntry(const YamlNode& node, std::string path, const CsvTable& table, Report& map_report, Report& csv_report)
      : map_(node, std::move(path), map_report), node_(node), table_(table), report_(map_report), csv_report_(csv_report) {}

  MapReader& map() { return map_; }

  std::string text(std::string_view key, bool needed = false);
  /// The column that `key` names, by its heading or counted from 1.
  std::optional<std::size_t> column(std::string_view key, bool needed);
  /// Lines whose cells are what `where` asks for.
  std::vector<const CsvTable::Line*> matching();
  /// The number in a cell; nothing when it is empty. What is no number is told at its place in the CSV.
  std::optional<RawNumber> cell(const CsvTable::Line& line, std::size_t column);
  /// [Pa], above 0.
  std::optional<double> stress_of(std::string_view key);

 private:
  std::optional<std::size_t> find_column(const YamlNode& node, const std::string& path);

  MapReader map_;
  const YamlNode& node_;
  const CsvTable& table_;
  Report& report_;
  Report& csv_report_;
};

}  // namespace regolab::gap
