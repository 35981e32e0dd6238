#include "scheduler/rpc/analysis_convert.h"

#include <algorithm>

#include "input/yaml_tree.h"

namespace regolab {
namespace {

v1::LevelStatistics to_proto(const analysis::LevelStatistics& level) {
  v1::LevelStatistics out;
  out.set_label(level.label);
  out.set_runs(level.runs);
  out.set_sum(level.sum);
  out.set_mean(level.mean);
  if (level.half_width_95) out.set_half_width_95(*level.half_width_95);
  return out;
}

v1::FactorAnalysis to_proto(const analysis::FactorAnalysis& factor) {
  v1::FactorAnalysis out;
  out.set_name(factor.name);
  out.set_unit(factor.unit);
  for (const auto& level : factor.levels) *out.add_levels() = to_proto(level);
  out.set_range(factor.range);
  if (factor.range_standard_error) out.set_range_standard_error(*factor.range_standard_error);
  out.set_rank(factor.rank);
  out.set_highest_level(factor.highest_level);
  out.set_lowest_level(factor.lowest_level);
  out.set_sum_of_squares(factor.sum_of_squares);
  out.set_degrees_of_freedom(factor.degrees_of_freedom);
  if (factor.f) out.set_f(*factor.f);
  if (factor.p) out.set_p(*factor.p);
  out.set_leave_one_out_range_min(factor.leave_one_out_range_min);
  out.set_leave_one_out_range_max(factor.leave_one_out_range_max);
  out.set_leaning_on_point(factor.leaning_on_point);
  out.set_fragile(factor.fragile);
  out.set_fragile_why(factor.fragile_why);
  return out;
}

v1::CompareCell to_proto(const analysis::CompareCell& cell) {
  v1::CompareCell out;
  out.set_test(cell.test);
  out.set_article(cell.article);
  if (cell.ours) out.set_ours(*cell.ours);
  if (cell.ours_standard_error) out.set_ours_standard_error(*cell.ours_standard_error);
  out.set_missing(cell.missing);
  return out;
}

v1::CompareResponse to_proto(const analysis::CompareResponse& response) {
  v1::CompareResponse out;
  out.set_response(response.response);
  out.set_unit(response.unit);
  out.set_tests_compared(response.tests_compared);
  out.set_correlation(response.correlation);
  out.set_mean_error(response.mean_error);
  out.set_mean_absolute_relative_error(response.mean_absolute_relative_error);
  for (const auto& cell : response.cells) *out.add_cells() = to_proto(cell);
  for (const auto& name : response.leading_factors_article) out.add_leading_factors_article(name);
  for (const auto& name : response.leading_factors_ours) out.add_leading_factors_ours(name);
  return out;
}

}  // namespace

v1::Diagnostic to_proto(const Diagnostic& diagnostic) {
  v1::Diagnostic out;
  const auto sound = [](std::string text) {  // the wire carries UTF-8 alone
    if (first_bad_byte(text)) std::ranges::replace_if(text, [](unsigned char c) { return c < 0x20 || c > 0x7E; }, '?');
    return text;
  };
  out.set_file(sound(diagnostic.file));
  out.set_line(static_cast<std::uint32_t>(std::max(diagnostic.line, 0)));
  out.set_column(static_cast<std::uint32_t>(std::max(diagnostic.column, 0)));
  out.set_text(sound(diagnostic.text));
  if (!first_bad_byte(diagnostic.source_line)) out.set_source_line(diagnostic.source_line);
  return out;
}

v1::DesignSummary to_proto(const Design& design) {
  v1::DesignSummary out;
  out.set_name(design.name);
  out.set_array(design.array);
  out.set_points(static_cast<std::uint32_t>(design.points.size()));
  out.set_seeds(static_cast<std::uint32_t>(design.seeds.size()));
  out.set_strength(static_cast<std::uint32_t>(design.quality.strength));
  out.set_balanced(design.quality.balanced);
  out.set_error_degrees_of_freedom(design.quality.error_degrees_of_freedom);
  for (const std::string& line : factor_columns(design)) out.add_factor_columns(line);
  out.set_profile(design.profile);
  for (const std::string& name : test_names(design)) out.add_tests(name);
  for (const std::string& note : design.notes) out.add_notes(note);
  return out;
}

v1::ResponseAnalysis to_proto(const analysis::ResponseAnalysis& analysis) {
  v1::ResponseAnalysis out;
  out.set_response(analysis.response);
  out.set_unit(analysis.unit);
  out.set_runs_used(analysis.runs_used);
  for (const std::string& line : analysis.missing) out.add_missing(line);
  out.set_mean(analysis.mean);
  out.set_residual_standard_deviation(analysis.residual_standard_deviation);
  out.set_error_degrees_of_freedom(analysis.error_degrees_of_freedom);
  if (analysis.seed_standard_deviation) out.set_seed_standard_deviation(*analysis.seed_standard_deviation);
  for (const auto& factor : analysis.factors) *out.add_factors() = to_proto(factor);
  for (const std::string& note : analysis.notes) out.add_notes(note);
  return out;
}

v1::RangeReply to_proto(const std::string& experiment, const std::vector<analysis::ResponseAnalysis>& responses) {
  v1::RangeReply out;
  out.set_experiment(experiment);
  for (const auto& response : responses) *out.add_responses() = to_proto(response);
  return out;
}

v1::CheckArticleReply to_proto(const analysis::ArticleCheck& check) {
  v1::CheckArticleReply out;
  for (const analysis::CheckEntry& entry : check.entries) {
    v1::CheckEntry& line = *out.add_entries();
    line.set_table(entry.table);
    line.set_entry(entry.entry);
    line.set_unit(entry.unit);
    line.set_printed(entry.printed);
    line.set_recomputed(entry.recomputed);
    line.set_agrees(entry.agrees);
    line.set_explanation(entry.explanation);
  }
  for (const std::string& finding : check.findings) out.add_findings(finding);
  return out;
}

v1::CompareArticleReply to_proto(const std::string& experiment, const analysis::ArticleComparison& comparison) {
  v1::CompareArticleReply out;
  out.set_experiment(experiment);
  for (const auto& response : comparison.responses) *out.add_responses() = to_proto(response);
  for (const std::string& note : comparison.notes) out.add_notes(note);
  return out;
}

v1::ResultsReply to_proto(const ResultTable& table, const std::string& name) {
  v1::ResultsReply out;
  out.set_experiment(table.experiment);
  out.set_name(name);
  out.set_array(table.array);
  for (const TableFactor& factor : table.factors) {
    v1::FactorColumn& column = *out.add_factors();
    column.set_name(factor.name);
    column.set_unit(factor.unit);
    for (const std::string& level : factor.levels) column.add_levels(level);
  }
  for (const TableResponse& response : table.responses) {
    v1::ResponseColumn& column = *out.add_responses();
    column.set_id(response.id);
    column.set_unit_si(response.unit);
  }
  for (const TableRow& row : table.rows) {
    v1::ResultRow& line = *out.add_rows();
    line.set_point(row.point);
    line.set_seed(row.seed);
    for (const int level : row.level) line.add_level(level);
    for (const auto& [id, value] : row.value) (*line.mutable_value_si())[id] = value;
    for (const auto& [id, why] : row.missing) (*line.mutable_missing())[id] = why;
  }
  return out;
}

}  // namespace regolab
