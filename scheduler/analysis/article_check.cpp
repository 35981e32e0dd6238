#include <algorithm>
#include <cmath>

#include "scheduler/analysis/article.h"
#include "scheduler/analysis/article_tables.h"
#include "scheduler/analysis/level_means.h"
#include "scheduler/analysis/range.h"
#include "vocab/units.h"

namespace regolab::analysis {
namespace {

constexpr double kGrainDensity = 2.93;  // g/cm3 [article Sec. 3.1.3]
constexpr double kPrinted = 0.01;       // last digit of every range factor and void ratio
constexpr double kSlack = 1e-9;

/// One row of a table of range factors beside the data it is made from.
struct RangeRow {
  const ArticleResponse& response;
  std::vector<std::string> printed;  // [8] as printed
  std::vector<double> data;          // [32] in printed units
};

std::vector<RangeRow> range_rows() {
  std::vector<RangeRow> rows;
  for (const ArticleResponse& response : article_responses()) {
    const auto table = article_table(response.range_table);
    const auto line = std::ranges::find_if(table, [&](const auto& cells) { return cells.front() == response.id; });
    RangeRow row{.response = response, .printed = {line->begin() + 1, line->end()}, .data = {}};
    const auto data = article_table(response.data_table);
    for (std::size_t test = 1; test < data.size(); ++test) {
      row.data.push_back(printed_number(data[test][static_cast<std::size_t>(response.column)]));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// R of one factor [article Eq. 2]: plain level means of 8 tests each.
double range_factor(const std::vector<double>& data, std::size_t factor) {
  double sum[4] = {};
  for (std::size_t test = 0; test < data.size(); ++test) sum[article_design().rows[test][factor]] += data[test];
  const auto [low, high] = std::ranges::minmax(sum);
  return (high - low) / 8;
}

/// Printed to two decimals, from data that were themselves rounded: each level mean may be half a digit off.
bool agrees(double printed, double recomputed, double last_digit) {
  return std::abs(printed - recomputed) <= kPrinted / 2 + last_digit + kSlack;
}

bool agrees_with(const RangeRow& row, const std::vector<double>& data, std::size_t factor) {
  return agrees(printed_number(row.printed[factor]), range_factor(data, factor), row.response.last_digit);
}

std::size_t count_agreeing(const RangeRow& row, const std::vector<double>& data) {
  std::size_t n = 0;
  for (std::size_t factor = 0; factor < row.printed.size(); ++factor) n += agrees_with(row, data, factor) ? 1 : 0;
  return n;
}

/// The one test whose result, counted as 0, makes the whole row agree; 0 when there is none.
std::size_t test_counted_as_zero(const RangeRow& row) {
  for (std::size_t test = 0; test < row.data.size(); ++test) {
    std::vector<double> data = row.data;
    data[test] = 0;
    if (count_agreeing(row, data) == row.printed.size()) return test + 1;
  }
  return 0;
}

/// The printed number with one digit put in that agrees with `recomputed`, or empty.
std::string with_lost_digit(const std::string& printed, double recomputed, double last_digit) {
  for (std::size_t at = 0; at <= printed.size(); ++at) {
    for (char digit = '0'; digit <= '9'; ++digit) {
      std::string longer = printed;
      longer.insert(at, 1, digit);
      if (agrees(printed_number(longer), recomputed, last_digit)) return longer;
    }
  }
  return {};
}

/// "7.43": two decimals, as the article prints.
std::string two_decimals(double value) {
  const auto hundredths = static_cast<long>(std::lround(std::abs(value) * 100));
  const std::string cents = std::to_string(hundredths % 100);
  return (value < 0 ? "-" : "") + std::to_string(hundredths / 100) + (cents.size() == 1 ? ".0" : ".") + cents;
}

std::string explain(const RangeRow& row, std::size_t factor, std::size_t zero_test) {
  const double recomputed = range_factor(row.data, factor);
  if (zero_test > 0) {
    std::vector<double> data = row.data;
    data[zero_test - 1] = 0;
    return "follows when test " + std::to_string(zero_test) + " counts as 0 instead of the " +
           two_decimals(row.data[zero_test - 1]) + " printed in Table " + std::to_string(row.response.data_table) +
           ": then " + two_decimals(range_factor(data, factor));
  }
  const std::string longer = with_lost_digit(row.printed[factor], recomputed, row.response.last_digit);
  if (!longer.empty()) return "a digit is lost in print: " + row.printed[factor] + " for " + longer;
  return "not explained: the data give " + two_decimals(recomputed);
}

void check_ranges(ArticleCheck& check) {
  for (const RangeRow& row : range_rows()) {
    const std::string table = "Table " + std::to_string(row.response.range_table);
    const std::size_t agreeing = count_agreeing(row, row.data);
    const std::size_t zero_test = agreeing < row.printed.size() ? test_counted_as_zero(row) : 0;
    for (std::size_t factor = 0; factor < row.printed.size(); ++factor) {
      const bool good = agrees_with(row, row.data, factor);
      check.entries.push_back({.table = table,
                               .entry = row.response.id + ", " + article_design().factors[factor],
                               .unit = std::string(door_unit(row.response.si_unit).name),
                               .printed = printed_number(row.printed[factor]),
                               .recomputed = range_factor(row.data, factor),
                               .agrees = good,
                               .explanation = good ? "" : explain(row, factor, zero_test)});
    }
    if (agreeing == row.printed.size()) continue;
    const std::string count = std::to_string(row.printed.size() - agreeing) + " of " + std::to_string(row.printed.size());
    check.findings.push_back(
        table + ", " + row.response.id + ": " + count + " range factors do not follow from Table " +
        std::to_string(row.response.data_table) +
        (zero_test > 0 ? "; all do when test " + std::to_string(zero_test) + " counts as 0, as a missing run would" : ""));
  }
}

/// e = rho_P/rho - 1 [article Eq. 3, read as void ratio: the printed formula gives the porosity]. The density is known to
/// half a digit, so e to an interval.
void check_void_ratios(ArticleCheck& check) {
  const auto table = article_table(5);
  for (std::size_t test = 1; test < table.size(); ++test) {
    const double density = printed_number(table[test][1]);
    const double printed = printed_number(table[test][2]);
    const double low = kGrainDensity / (density + kPrinted / 2) - 1 - kPrinted / 2;
    const double high = kGrainDensity / (density - kPrinted / 2) - 1 + kPrinted / 2;
    const double recomputed = kGrainDensity / density - 1;
    const bool good = printed >= low - kSlack && printed <= high + kSlack;
    const std::string why = "no density that rounds to " + table[test][1] +
                            " g/cm3 gives this void ratio; e = " + two_decimals(printed) + " belongs to " +
                            two_decimals(kGrainDensity / (1 + printed)) + " g/cm3";
    check.entries.push_back({.table = "Table 5",
                             .entry = "void_ratio from bulk_density, test " + table[test][0],
                             .unit = "1",
                             .printed = printed,
                             .recomputed = recomputed,
                             .agrees = good,
                             .explanation = good ? "" : why});
    if (!good) {
      check.findings.push_back("Table 5, test " + table[test][0] + ": density " + table[test][1] + " and void ratio " +
                               table[test][2] + " contradict each other (2.93/rho - 1 = " + two_decimals(recomputed) + ")");
    }
  }
}

/// One line on all range factors, first among the findings.
void count_ranges(ArticleCheck& check) {
  const auto is_range = [](const CheckEntry& entry) { return entry.table != "Table 5"; };
  const auto all = std::ranges::count_if(check.entries, is_range);
  const auto good =
      std::ranges::count_if(check.entries, [&](const CheckEntry& entry) { return is_range(entry) && entry.agrees; });
  check.findings.insert(check.findings.begin(),
                        std::to_string(good) + " of " + std::to_string(all) +
                            " range factors of Tables 4, 6, 8 and 10 follow from Tables 3, 5, 7 and 9");
}

void note_design(ArticleCheck& check) {
  const ArticleDesign& design = article_design();
  if (design.restorations == 1) {
    check.findings.push_back("Table 2 prints no K_N for test 5; " + design.restored_level +
                             " N/m is the only level that makes the array orthogonal, and is used");
  }
}

/// Effects that range analysis would read off the article's data but that rest on one test.
void note_fragile_effects(ArticleCheck& check) {
  const auto analyses = analyse_ranges(article_results(), "");
  if (!analyses.ok()) return;
  for (const ResponseAnalysis& analysis : *analyses) {
    for (const FactorAnalysis& factor : analysis.factors) {
      if (!factor.fragile) continue;
      check.findings.push_back(
          analysis.response + ": the effect of " + factor.name + " leans on one test: " + factor.fragile_why +
          (factor.f ? " (F = " + short_number(*factor.f) + ", p = " + short_number(*factor.p) + " with all tests)" : ""));
    }
  }
}

}  // namespace

ArticleCheck check_article() {
  ArticleCheck check;
  note_design(check);
  check_ranges(check);
  check_void_ratios(check);
  count_ranges(check);
  note_fragile_effects(check);
  return check;
}

}  // namespace regolab::analysis
