#include "scheduler/analysis/article_tables.h"

#include <algorithm>
#include <charconv>

#include "scheduler/analysis/article.h"
#include "vocab/units.h"

namespace regolab::analysis {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

constexpr std::size_t kNormalStiffness = 1;  // column of K_N among the factors
constexpr std::size_t kGapTest = 5;          // Table 2 prints no K_N there

/// Table 2's level of a cell: numbers ascending; 12 is the mixture, Non is none.
int level_of(const std::vector<std::string>& printed_levels, const std::string& cell) {
  return static_cast<int>(std::ranges::find(printed_levels, cell) - printed_levels.begin());
}

/// Whether every pair of columns holds each of the 16 level pairs twice.
bool orthogonal(const std::vector<std::vector<int>>& rows) {
  for (std::size_t a = 0; a < rows.front().size(); ++a) {
    for (std::size_t b = a + 1; b < rows.front().size(); ++b) {
      int count[4][4] = {};
      for (const auto& row : rows) ++count[row[a]][row[b]];
      for (const auto& line : count) {
        if (std::ranges::any_of(line, [](int n) { return n != 2; })) return false;
      }
    }
  }
  return true;
}

/// Puts into test 5 the one K_N that makes the array orthogonal.
void restore_gap(ArticleDesign& design) {
  int found = 0;
  for (int level = 0; level < 4; ++level) {
    design.rows[kGapTest - 1][kNormalStiffness] = level;
    if (!orthogonal(design.rows)) continue;
    ++design.restorations;
    found = level;
  }
  design.rows[kGapTest - 1][kNormalStiffness] = found;
  design.restored_level = design.levels[kNormalStiffness][static_cast<std::size_t>(found)];
}

ArticleDesign build_design() {
  const std::vector<std::string> stiffness{"2.5e4", "5e4", "7.5e4", "1e5"};
  const std::vector<std::string> damping{"0.25", "0.50", "0.75", "1.00"};
  const std::vector<std::vector<std::string>> printed{
      {"0.1", "20", "40", "60"}, stiffness, damping, stiffness, damping, {"0.5", "1", "1.5", "2"}, {"2", "4", "6", "12"},
      {"Non", "X", "Z", "XZ"}};
  const std::vector<std::string> stiffness_labels{"25000", "50000", "75000", "100000"};
  const std::vector<std::string> damping_labels{"0.25", "0.5", "0.75", "1"};
  ArticleDesign design;
  design.factors = {"theta_F", "K_N", "eta_N", "K_T", "eta_T", "L_S", "N_E", "rotation"};
  design.units = {"deg", "N/m", "N s/m", "N/m", "N s/m", "cm", "1", "1"};
  design.levels = {printed[0], stiffness_labels,           damping_labels,          stiffness_labels, damping_labels,
                   printed[5], {"2", "4", "6", "mixture"}, {"none", "x", "z", "xz"}};
  const auto table = article_table(2);
  for (std::size_t test = 1; test < table.size(); ++test) {
    std::vector<int> row;
    for (std::size_t i = 0; i < design.factors.size(); ++i) row.push_back(level_of(printed[i], table[test][i + 1]));
    design.rows.push_back(std::move(row));
  }
  restore_gap(design);
  return design;
}

}  // namespace

std::vector<std::vector<std::string>> article_table(int table) {
  std::vector<std::vector<std::string>> rows;
  std::string_view text = article_csv(table);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) rows.push_back(split(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return rows;
}

double printed_number(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

const std::vector<ArticleResponse>& article_responses() {
  static const std::vector<ArticleResponse> responses{
      {"contacts_per_particle", "1", 3, 1, 4, 0.01},
      {"bulk_density", "kg/m3", 5, 1, 6, 0.01},
      {"void_ratio", "1", 5, 2, 6, 0.01},
      {"repose_angle", "rad", 7, 1, 8, 0.01},
      {"sigma1_at_sigma3_1.25kPa", "Pa", 9, 1, 10, 0.1},
      {"sigma1_at_sigma3_2.5kPa", "Pa", 9, 2, 10, 0.1},
      {"sigma1_at_sigma3_5kPa", "Pa", 9, 3, 10, 0.1},
      {"sigma1_at_sigma3_10kPa", "Pa", 9, 4, 10, 0.1},
  };
  return responses;
}

const ArticleDesign& article_design() {
  static const ArticleDesign design = build_design();
  return design;
}

ResultTable article_results() {
  const ArticleDesign& design = article_design();
  ResultTable table{.experiment = "article",
                    .array = "L32",
                    .factors = {},
                    .fixed = {{"gravity", "1.63 m/s2"}, {"particle_density", "2.93 g/cm3"}},
                    .responses = {},
                    .rows = {}};
  for (std::size_t i = 0; i < design.factors.size(); ++i)
    table.factors.push_back({design.factors[i], design.units[i], design.levels[i]});
  for (std::size_t test = 1; test <= design.rows.size(); ++test) {
    table.rows.push_back(
        {.point = static_cast<int>(test), .seed = 0, .level = design.rows[test - 1], .value = {}, .missing = {}});
  }
  for (const ArticleResponse& response : article_responses()) {
    table.responses.push_back({response.id, response.si_unit});
    const auto data = article_table(response.data_table);
    for (std::size_t test = 1; test < data.size(); ++test) {
      const double printed = printed_number(data[test][static_cast<std::size_t>(response.column)]);
      table.rows[test - 1].value[response.id] = printed / door_unit(response.si_unit).factor;
    }
  }
  return table;
}

}  // namespace regolab::analysis
