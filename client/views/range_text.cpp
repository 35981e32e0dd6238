#include "client/views/range_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "client/number_text.h"
#include "client/table_print.h"
#include "client/views/missing.h"
#include "client/views/names.h"

namespace regolab::client {
namespace {

constexpr double kSignificant = 0.05;
constexpr int kReasonsShown = 5;

std::optional<double> error_of_range(const pb::FactorAnalysis& factor) {
  return factor.has_range_standard_error() ? std::optional(factor.range_standard_error()) : std::nullopt;
}

std::string marks_of(const pb::FactorAnalysis& factor) {
  std::string marks = factor.has_p() && factor.p() < kSignificant ? "*" : " ";
  return marks + (factor.fragile() ? "!" : " ");
}

std::vector<const pb::FactorAnalysis*> by_rank(const pb::ResponseAnalysis& analysis) {
  std::vector<const pb::FactorAnalysis*> factors;
  for (const auto& factor : analysis.factors()) factors.push_back(&factor);
  std::stable_sort(factors.begin(), factors.end(), [](const auto* a, const auto* b) { return a->rank() < b->rank(); });
  return factors;
}

const pb::FactorAnalysis* factor_named(const pb::ResponseAnalysis& analysis, const std::string& name) {
  for (const auto& factor : analysis.factors()) {
    if (factor.name() == name) return &factor;
  }
  return nullptr;
}

/// Every missing cell is counted, the first few are told.
std::string missing_text(const pb::ResponseAnalysis& analysis) {
  if (analysis.missing().empty()) return {};
  std::string text = fmt::format("  missing: {} cells, left out, not filled\n", analysis.missing_size());
  for (int i = 0; i < std::min(analysis.missing_size(), kReasonsShown); ++i) text += "    " + analysis.missing(i) + "\n";
  if (analysis.missing_size() > kReasonsShown)
    text += fmt::format("    and {} more (--json lists all)\n", analysis.missing_size() - kReasonsShown);
  return text;
}

std::string headline(const pb::ResponseAnalysis& a) {
  std::string text =
      with_unit(a.response(), a.unit()) + fmt::format(": mean {}, {} runs", significant(a.mean(), 4), a.runs_used());
  if (a.error_degrees_of_freedom() > 0) {
    text += fmt::format(", residual spread {} ({} degrees of freedom)", significant(a.residual_standard_deviation(), 2),
                        a.error_degrees_of_freedom());
  }
  if (a.has_seed_standard_deviation())
    text += fmt::format(", spread between seeds {}", significant(a.seed_standard_deviation(), 2));
  return text + "\n";
}

Table factor_table(const pb::ResponseAnalysis& analysis) {
  Table table({{"rank"},
               {"factor", "", Align::kLeft},
               {"R"},
               {"highest at"},
               {"lowest at"},
               {"df"},
               {"F"},
               {"p"},
               {"R without one run"},
               {"leans on"},
               {"", "", Align::kLeft}});
  for (const auto* f : by_rank(analysis)) {
    table.add(
        {std::to_string(f->rank()), with_unit(f->name(), f->unit()), with_uncertainty(f->range(), error_of_range(*f)),
         f->highest_level(), f->lowest_level(), std::to_string(f->degrees_of_freedom()),
         f->has_f() ? significant(f->f(), 3) : "-", f->has_p() ? p_text(f->p()) : "-",
         fmt::format("{} to {}", significant(f->leave_one_out_range_min(), 3), significant(f->leave_one_out_range_max(), 3)),
         f->leaning_on_point() > 0 ? fmt::format("point {}", f->leaning_on_point()) : "-", marks_of(*f)});
  }
  return table;
}

/// "0.1: 1.724 (13.79)": level, k, K.
std::string level_cell(const pb::LevelStatistics& level, int decimals) {
  if (level.runs() == 0) return level.label() + ": no runs";
  return fmt::format("{}: {} ({})", level.label(), fixed(level.mean(), decimals),
                     fixed(level.sum(), std::max(0, decimals - 1)));
}

Table level_table(const pb::ResponseAnalysis& analysis) {
  std::size_t most = 0;
  std::vector<double> means;
  for (const auto& factor : analysis.factors()) {
    most = std::max(most, static_cast<std::size_t>(factor.levels_size()));
    for (const auto& level : factor.levels()) means.push_back(level.mean());
  }
  const int decimals = decimals_for(means, 4);
  std::vector<Column> columns{{"factor", "", Align::kLeft}, {"±95 %"}};
  for (std::size_t i = 1; i <= most; ++i) columns.push_back({fmt::format("level {}: k (K)", i), "", Align::kLeft});
  Table table(std::move(columns));
  for (const auto* factor : by_rank(analysis)) {
    double half_width = 0;
    for (const auto& level : factor->levels()) half_width = std::max(half_width, level.half_width_95());
    std::vector<std::string> cells{with_unit(factor->name(), factor->unit()),
                                   half_width > 0 ? fixed(half_width, decimals) : "-"};
    for (const auto& level : factor->levels()) cells.push_back(level_cell(level, decimals));
    cells.resize(most + 2);
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

std::string range_matrix_text(const pb::RangeReply& range) {
  std::vector<Column> columns{{"R", "", Align::kLeft}};
  std::vector<std::string> names;
  bool errors = false;
  for (const auto& response : range.responses()) {
    columns.push_back({short_name(response.response()) + "  ", shown_unit(response.unit()) + "  "});
    for (const auto& factor : response.factors()) {
      errors = errors || factor.has_range_standard_error();
      if (std::find(names.begin(), names.end(), factor.name()) == names.end()) names.push_back(factor.name());
    }
  }
  Table table(std::move(columns));
  const auto add = [&](const std::string& title, auto&& cell) {
    std::vector<std::string> cells{title};
    for (const auto& response : range.responses()) cells.push_back(cell(response));
    table.add(std::move(cells));
  };
  for (const std::string& name : names) {
    add(name, [&](const auto& response) {
      const auto* factor = factor_named(response, name);
      if (factor == nullptr) return std::string("-  ");
      const auto error = error_of_range(*factor);
      return (error ? with_uncertainty(factor->range(), error) : significant(factor->range(), 3)) + marks_of(*factor);
    });
  }
  add("mean", [](const auto& r) { return significant(r.mean(), 4) + "  "; });
  add("residual spread", [](const auto& r) {
    return (r.error_degrees_of_freedom() > 0 ? significant(r.residual_standard_deviation(), 2) : "-") + "  ";
  });
  add("runs", [](const auto& r) { return std::to_string(r.runs_used()) + "  "; });

  std::string text = table.text();
  text += fmt::format("R = largest less smallest level mean{}; * p < 0.05, ! fragile: leans on one run\n",
                      errors ? ", ± its standard error over seeds" : "");
  MissingCells missing;
  for (const auto& response : range.responses()) {
    for (const auto& cell : response.missing()) missing.add(short_name(response.response()), reason_alone(cell), 0);
  }
  if (!missing.empty()) text += "missing cells are left out, not filled\n" + missing.text("");
  return text;
}

std::string range_detail_text(const pb::ResponseAnalysis& analysis) {
  std::string text = headline(analysis) + missing_text(analysis) + "\n" + factor_table(analysis).text(2) + "\n" +
                     level_table(analysis).text(2);
  for (const auto* factor : by_rank(analysis)) {
    if (factor->fragile()) text += fmt::format("  ! {} is fragile: {}\n", factor->name(), factor->fragile_why());
  }
  for (const auto& note : analysis.notes()) text += "  note: " + note + "\n";
  return text;
}

}  // namespace regolab::client
