/// The results of one experiment as a table: what range analysis, comparison and export all read.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace regolab {

struct TableFactor {
  std::string name;                 ///< as the design names it: theta_F, K_N, ... or any field a user varies
  std::string unit;                 ///< door unit of the level labels, "1" when none
  std::vector<std::string> levels;  ///< labels in design order, e.g. "0.1", "20"
};

struct TableResponse {
  std::string id;    ///< observation id
  std::string unit;  ///< SI unit of the values
};

struct TableRow {
  int point = 0;                               ///< 1-based row of the design
  std::uint64_t seed = 0;
  std::vector<int> level;                      // [n_factors] 0-based level index
  std::map<std::string, double> value;         ///< response id -> SI value; absent = missing
  std::map<std::string, std::string> missing;  ///< response id -> why (job failed: reason; pending; cancelled)
};

struct ResultTable {
  std::string experiment;
  std::string array;                     ///< "L32", "table", ...
  std::vector<TableFactor> factors;
  std::map<std::string, std::string> fixed;  ///< parameters that do not vary, as shown: "gravity" -> "1.63 m/s2"
  std::vector<TableResponse> responses;
  std::vector<TableRow> rows;            ///< ordered by point, then seed
};

}  // namespace regolab
