#include "client/table_print.h"

#include <algorithm>
#include <cassert>

namespace regolab::client {
namespace {

std::string padded(const std::string& cell, int width, Align align) {
  const std::string blanks(static_cast<std::size_t>(std::max(0, width - display_width(cell))), ' ');
  return align == Align::kLeft ? cell + blanks : blanks + cell;
}

void append_line(std::string& text, int indent, const std::string& line) {
  const auto end = line.find_last_not_of(' ');
  if (end != std::string::npos) text += std::string(static_cast<std::size_t>(indent), ' ') + line.substr(0, end + 1);
  text += '\n';
}

}  // namespace

int display_width(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void Table::add(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

std::string Table::text(int indent) const {
  std::vector<int> width;
  bool units = false;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    int w = std::max(display_width(columns_[c].title), display_width(columns_[c].unit));
    for (const auto& row : rows_) w = std::max(w, display_width(row[c]));
    width.push_back(w);
    units = units || !columns_[c].unit.empty();
  }
  const auto line_of = [&](auto&& cell) {
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      line += (c == 0 ? "" : "  ") + padded(cell(c), width[c], columns_[c].align);
    }
    return line;
  };
  std::string text;
  append_line(text, indent, line_of([&](std::size_t c) { return columns_[c].title; }));
  if (units) append_line(text, indent, line_of([&](std::size_t c) { return columns_[c].unit; }));
  append_line(text, indent, line_of([&](std::size_t c) { return std::string(static_cast<std::size_t>(width[c]), '-'); }));
  for (const auto& row : rows_) append_line(text, indent, line_of([&](std::size_t c) { return row[c]; }));
  return text;
}

}  // namespace regolab::client
