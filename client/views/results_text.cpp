#include "client/views/results_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "client/number_text.h"
#include "client/table_print.h"
#include "client/views/missing.h"
#include "client/views/names.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

constexpr int kDigits = 4;
constexpr int kResponsesAcross = 4;  // of the comparison, two columns each

/// A response's column in door units, with decimals that suit all of it.
struct ResponseColumnText {
  std::string id;
  double factor = 1;
  int decimals = 0;
};

ResponseColumnText column_text(const pb::ResultsReply& results, const pb::ResponseColumn& response) {
  const double factor = door_unit(response.unit_si()).factor;
  std::vector<double> values;
  for (const auto& row : results.rows()) {
    const auto value = row.value_si().find(response.id());
    if (value != row.value_si().end()) values.push_back(value->second * factor);
  }
  return {.id = response.id(), .factor = factor, .decimals = decimals_for(values, kDigits)};
}

/// Cells missing for one reason are told together: "point 7 seed 1: repose_angle, sigma1@5kPa: not settled (...)".
std::string missing_of_row(const pb::ResultRow& row) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const auto& [response, why] : row.missing()) by_reason[why].push_back(short_name(response));
  std::string text;
  for (auto& [why, responses] : by_reason) {
    std::sort(responses.begin(), responses.end());
    text += fmt::format("  point {} seed {}: {}: {}\n", row.point(), row.seed(), fmt::join(responses, ", "), why);
  }
  return text;
}

std::string number_or_dash(double value, int decimals, bool known) { return known ? fixed(value, decimals) : "-"; }

Table comparison_table(const pb::CompareArticleReply& comparison) {
  Table table({{"response", "", Align::kLeft},
               {"tests"},
               {"correlation"},
               {"mean error"},
               {"mean |error|", "%"},
               {"leading, article", "", Align::kLeft},
               {"leading, ours", "", Align::kLeft}});
  for (const auto& r : comparison.responses()) {
    table.add({with_unit(short_name(r.response()), r.unit()), std::to_string(r.tests_compared()), fixed(r.correlation(), 3),
               significant(r.mean_error(), 2), fixed(100 * r.mean_absolute_relative_error(), 1),
               fmt::format("{}", fmt::join(r.leading_factors_article(), ", ")),
               fmt::format("{}", fmt::join(r.leading_factors_ours(), ", "))});
  }
  return table;
}

/// Test by test for responses [first, last): the article's number, ours and its standard error over seeds.
std::string cells_text(const pb::CompareArticleReply& comparison, int first, int last) {
  std::vector<Column> columns{{"test"}};
  std::map<int, std::vector<std::string>> lines;
  for (int i = first; i < last; ++i) {
    const auto& response = comparison.responses(i);
    std::vector<double> values;
    for (const auto& cell : response.cells()) values.push_back(cell.article());
    const int decimals = decimals_for(values, kDigits);
    columns.push_back({short_name(response.response()), "article"});
    columns.push_back({shown_unit(response.unit()), "ours", Align::kLeft});
    for (const auto& cell : response.cells()) {
      auto& line = lines[cell.test()];
      line.resize(static_cast<std::size_t>(2 * (i - first)));
      line.push_back(fixed(cell.article(), decimals));
      line.push_back(cell.has_ours() ? fixed(cell.ours(), decimals) : "-");
      if (cell.has_ours() && cell.has_ours_standard_error())
        line.back() += " ±" + fixed(cell.ours_standard_error(), decimals);
    }
  }
  const std::size_t width = columns.size();
  Table table(std::move(columns));
  for (auto& [test, cells] : lines) {
    cells.insert(cells.begin(), std::to_string(test));
    cells.resize(width);
    table.add(cells);
  }
  return table.text();
}

}  // namespace

std::string results_text(const pb::ResultsReply& results, bool all) {
  std::vector<Column> columns{{"point"}, {"seed"}};
  for (const auto& factor : results.factors()) columns.push_back({factor.name(), shown_unit(factor.unit())});
  std::vector<ResponseColumnText> shown;
  for (const auto& response : results.responses()) {
    if (!all && !is_primary(response.id())) continue;
    shown.push_back(column_text(results, response));
    columns.push_back({short_name(response.id()), shown_unit(door_unit(response.unit_si()).name)});
  }
  Table table(std::move(columns));
  std::string missing;
  for (const auto& row : results.rows()) {
    std::vector<std::string> cells{std::to_string(row.point()), std::to_string(row.seed())};
    for (int f = 0; f < results.factors_size(); ++f) cells.push_back(label_of(results, row, f));
    for (const auto& column : shown) {
      const auto value = row.value_si().find(column.id);
      const bool known = value != row.value_si().end();
      cells.push_back(number_or_dash(known ? value->second * column.factor : 0, column.decimals, known));
    }
    table.add(std::move(cells));
    missing += missing_of_row(row);
  }
  return table.text() + (missing.empty() ? "" : "missing (-)\n" + missing);
}

std::string check_text(const pb::CheckArticleReply& check, bool all) {
  std::vector<std::string> order;
  std::map<std::string, std::pair<int, int>> agreeing;  // table -> agreeing, all
  Table table({{"table", "", Align::kLeft},
               {"entry", "", Align::kLeft},
               {"unit", "", Align::kLeft},
               {"printed"},
               {"recomputed"},
               {"", "", Align::kLeft}});
  std::vector<std::string> reasons;  // each once, in order; entries refer to them by number
  for (const auto& entry : check.entries()) {
    if (agreeing.find(entry.table()) == agreeing.end()) order.push_back(entry.table());
    auto& [good, total] = agreeing[entry.table()];
    good += entry.agrees() ? 1 : 0;
    ++total;
    if (entry.agrees() && !all) continue;
    std::string note = "agrees";
    if (!entry.agrees()) {
      auto at = std::find(reasons.begin(), reasons.end(), entry.explanation());
      if (at == reasons.end()) at = reasons.insert(reasons.end(), entry.explanation());
      note = fmt::format("differs [{}]", at - reasons.begin() + 1);
    }
    table.add({entry.table(), entry.entry(), shown_unit(entry.unit()), significant(entry.printed(), kDigits),
               significant(entry.recomputed(), kDigits), note});
  }
  std::string text;
  for (const auto& name : order) {
    text += fmt::format("{:<9}{} of {} entries follow from the data\n", name, agreeing[name].first, agreeing[name].second);
  }
  if (!table.empty()) text += "\n" + table.text();
  for (std::size_t i = 0; i < reasons.size(); ++i) text += fmt::format("[{}] {}\n", i + 1, reasons[i]);
  if (!check.findings().empty()) text += "\nfindings\n";
  for (const auto& finding : check.findings()) text += "  - " + finding + "\n";
  return text;
}

std::string comparison_text(const pb::CompareArticleReply& comparison, bool cells) {
  std::string text = comparison_table(comparison).text();
  text += "error = ours less the article's; leading = the two factors with the largest R\n";
  for (int first = 0; cells && first < comparison.responses_size(); first += kResponsesAcross) {
    text += "\n" + cells_text(comparison, first, std::min(first + kResponsesAcross, comparison.responses_size()));
  }
  MissingCells missing;
  for (const auto& response : comparison.responses()) {
    for (const auto& cell : response.cells()) {
      if (!cell.missing().empty()) missing.add(short_name(response.response()), reason_alone(cell.missing()), cell.test());
    }
  }
  if (!missing.empty()) text += "missing (-)\n" + missing.text("tests");
  for (const auto& note : comparison.notes()) text += "note: " + note + "\n";
  return text;
}

}  // namespace regolab::client
