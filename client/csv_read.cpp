#include "client/csv_read.h"

namespace regolab::client {

std::vector<std::string> csv_cells(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') cells.emplace_back();
    else if (c != '"') cells.back() += c;
  }
  return cells;
}

}  // namespace regolab::client
