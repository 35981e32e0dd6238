/// Aligned text tables.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace regolab::client {

enum class Align { kLeft, kRight };

struct Column {
  std::string title;
  std::string unit = {};  ///< second header line; left out when no column has one
  Align align = Align::kRight;
};

class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// REQUIRES: as many cells as columns. Cells may hold UTF-8; every code point counts as one column.
  void add(std::vector<std::string> cells);
  bool empty() const { return rows_.empty(); }

  /// `indent` spaces before, two between columns, no trailing blanks, a rule under the header.
  std::string text(int indent = 0) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Columns a UTF-8 text takes.
int display_width(std::string_view text);

}  // namespace regolab::client
