/// CSV as people hand it in: no line breaks inside cells.
#pragma once
#include <string>
#include <vector>

namespace regolab::client {

/// Cells of one line; quotes around a cell and a carriage return at its end are taken away.
std::vector<std::string> csv_cells(std::string line);

}  // namespace regolab::client
