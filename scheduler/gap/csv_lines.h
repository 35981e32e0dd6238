/// CSV cells with their places. Cells may be quoted; a line break inside quotes is not read.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace regolab::gap {

struct CsvCell {
  std::string text;  ///< without quotes and surrounding blanks
  int column = 1;    ///< where it starts in its line [bytes from 1]
};

inline std::vector<CsvCell> csv_cells(std::string_view line) {
  std::vector<CsvCell> cells;
  CsvCell cell;
  bool quoted = false;
  const auto close = [&](int next) {
    const auto from = cell.text.find_first_not_of(" \t"), to = cell.text.find_last_not_of(" \t");
    cell.text = from == std::string::npos ? "" : cell.text.substr(from, to - from + 1);
    cells.push_back(std::move(cell));
    cell = {.text = "", .column = next};
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') cell.text += '"', ++i;
    else if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) close(static_cast<int>(i) + 2);
    else cell.text += c;
  }
  close(1);
  return cells;
}

/// Calls `each` with every line, without its end; a last line without an end counts, nothing after a last end does not.
template <class Each>
void for_each_line(std::string_view text, const Each& each) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // spreadsheets put it in front
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    each(line);
  }
}

}  // namespace regolab::gap
