/// The article's tables as data: CSV text compiled in, and its readers.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace regolab::analysis {

/// The text of scheduler/analysis/article/table<n>.csv; empty when there is none.
std::string_view article_csv(int table);

/// Cells of one table, header first. [n_rows][n_columns]
std::vector<std::vector<std::string>> article_table(int table);

/// One of the article's responses and where it stands.
struct ArticleResponse {
  std::string id;
  std::string si_unit;
  int data_table = 0;     ///< 3, 5, 7 or 9
  int column = 0;         ///< of the data table
  int range_table = 0;    ///< 4, 6, 8 or 10
  double last_digit = 0;  ///< of the data as printed: 0.01, or 0.1 in Table 9
};

const std::vector<ArticleResponse>& article_responses();

/// The factors in the order of Table 2, and the levels of Table 2 for each test, as labels of a design: "0.1", "25000",
/// "mixture", "xz".
struct ArticleDesign {
  std::vector<std::string> factors;              // [8]
  std::vector<std::string> units;                // [8] door units
  std::vector<std::vector<std::string>> levels;  // [8][4] ascending, N_E 2 4 6 mixture, rotation none x z xz
  std::vector<std::vector<int>> rows;            // [32][8] 0-based
  std::string restored_level;                    ///< K_N of test 5 as found
  int restorations = 0;                          ///< how many levels would make the array orthogonal there: 1 = unique
};

const ArticleDesign& article_design();

/// A number as printed.
double printed_number(const std::string& text);

}  // namespace regolab::analysis
