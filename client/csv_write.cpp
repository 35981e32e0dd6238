#include "client/csv_write.h"

#include <algorithm>

#include "client/number_text.h"
#include "client/views/names.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

/// The map's reasons in the order of the columns, so that the text does not depend on a hash.
std::string missing_text(const pb::ResultsReply& results, const pb::ResultRow& row) {
  std::string text;
  for (const auto& response : results.responses()) {
    const auto why = row.missing().find(response.id());
    if (why == row.missing().end()) continue;
    text += (text.empty() ? "" : "; ") + response.id() + ": " + why->second;
  }
  return text;
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i == 0 ? "" : ",") + csv_field(fields[i]);
  return line + "\n";
}

std::string results_csv(const pb::ResultsReply& results) {
  std::vector<std::string> fields{"point", "seed"};
  for (const auto& factor : results.factors()) fields.push_back(column_of(factor));
  for (const auto& response : results.responses()) fields.push_back(column_of(response));
  fields.push_back("missing");
  std::string text = csv_line(fields);
  for (const auto& row : results.rows()) {
    fields = {std::to_string(row.point()), std::to_string(row.seed())};
    for (int f = 0; f < results.factors_size(); ++f) fields.push_back(label_of(results, row, f));
    for (const auto& response : results.responses()) {
      const auto value = row.value_si().find(response.id());
      fields.push_back(value == row.value_si().end() ? "" : shortest(value->second * door_unit(response.unit_si()).factor));
    }
    fields.push_back(missing_text(results, row));
    text += csv_line(fields);
  }
  return text;
}

std::string range_csv(const pb::RangeReply& range) {
  const auto known = [](bool has, double value) { return has ? shortest(value) : std::string(); };
  std::string text = csv_line({"response", "unit", "runs_used", "mean", "residual_standard_deviation",
                               "error_degrees_of_freedom", "seed_standard_deviation", "factor", "factor_unit", "rank", "R",
                               "R_standard_error", "degrees_of_freedom", "F", "p", "R_without_one_run_min",
                               "R_without_one_run_max", "leaning_on_point", "fragile", "level", "runs", "K_sum", "k_mean",
                               "half_width_95"});
  for (const auto& r : range.responses()) {
    for (const auto& f : r.factors()) {
      for (const auto& level : f.levels()) {
        text += csv_line({r.response(), r.unit(), std::to_string(r.runs_used()), shortest(r.mean()),
                          shortest(r.residual_standard_deviation()), std::to_string(r.error_degrees_of_freedom()),
                          known(r.has_seed_standard_deviation(), r.seed_standard_deviation()), f.name(), f.unit(),
                          std::to_string(f.rank()), shortest(f.range()),
                          known(f.has_range_standard_error(), f.range_standard_error()),
                          std::to_string(f.degrees_of_freedom()), known(f.has_f(), f.f()), known(f.has_p(), f.p()),
                          shortest(f.leave_one_out_range_min()), shortest(f.leave_one_out_range_max()),
                          std::to_string(f.leaning_on_point()), f.fragile() ? "1" : "0", level.label(),
                          std::to_string(level.runs()), shortest(level.sum()), shortest(level.mean()),
                          known(level.has_half_width_95(), level.half_width_95())});
      }
    }
  }
  return text;
}

std::string curve_csv(const pb::Curve& curve) {
  const DoorUnit x = door_unit(curve.x_unit_si());
  const DoorUnit y = door_unit(curve.y_unit_si());
  std::string text = csv_line({curve.x_name() + unit_suffix(x.name), curve.y_name() + unit_suffix(y.name)});
  const int points = std::min(curve.x_si_size(), curve.y_si_size());
  for (int i = 0; i < points; ++i)
    text += csv_line({shortest(curve.x_si(i) * x.factor), shortest(curve.y_si(i) * y.factor)});
  return text;
}

}  // namespace regolab::client
