#include "scheduler/surrogate/dataset.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "vocab/profile.h"

namespace regolab::surrogate {
namespace {

constexpr std::string_view kProfile = "profile";      // what a run costs and how fine it is
constexpr std::string_view kParticles = "particles";  // the size of its specimen

std::vector<std::string> labels_of(const std::string& name) {
  if (name == kProfile) return {std::begin(kProfileNames), std::end(kProfileNames)};
  std::vector<std::string> labels;
  for (const Choice& choice : find_field(name)->choices) labels.emplace_back(choice.name);
  return labels;
}

/// Names that vary within a source or differ between sources, in the order met.
std::vector<std::string> varied(const std::vector<Source>& sources) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Source& source : sources) {
    for (const TableFactor& factor : source.table.factors) add(factor.name);
  }
  for (const auto& [name, text] : sources.front().table.fixed) {
    for (const Source& other : sources) {
      const auto found = other.table.fixed.find(name);
      if (found != other.table.fixed.end() && found->second != text) add(name);
    }
  }
  return names;
}

/// The value of column `name` in every row of a source: by level, or the same for all.
Result<std::vector<double>> values_of(const Source& source, const std::string& name) {
  const auto& factors = source.table.factors;
  const auto factor = std::ranges::find(factors, name, &TableFactor::name);
  if (factor != factors.end()) {
    std::vector<double> values;
    for (const std::string& label : factor->levels) {
      const auto value = input_value(name, label, factor->unit);
      if (!value.ok()) return value.error();
      values.push_back(*value);
    }
    return values;
  }
  const auto fixed = source.table.fixed.find(name);
  if (fixed == source.table.fixed.end()) {
    return invalid("experiment " + source.table.experiment + " does not say its " + name +
                   " (another experiment varies it) train them apart");
  }
  const auto value = input_value(name, fixed->second, "");
  if (!value.ok()) return value.error();
  return std::vector<double>{*value};
}

/// Mean and squared deviations of values that come one after the other [Welford 1962].
struct Sum {
  double mean = 0, squares = 0;
  int seeds = 0;
  void add(double v) {
    const double off = v - mean;
    mean += off / ++seeds;
    squares += off * (v - mean);
  }
};

/// A material that was run before is one row: seeds of all its runs together.
void merge(DataRow row, Dataset& data) {
  const auto same = std::ranges::find(data.rows, row.x, &DataRow::x);
  if (same == data.rows.end()) {
    data.rows.push_back(std::move(row));
    return;
  }
  same->source += "; " + row.source;
  for (const auto& [id, mean] : row.mean) {
    SeedMean& known = same->mean[id];
    const double both = known.seeds + mean.seeds, off = mean.value - known.value;
    known.squares += mean.squares + off * off * known.seeds * mean.seeds / both;
    known.value += off * mean.seeds / both;
    known.seeds += mean.seeds;
  }
}

void find_ranges(Dataset& data) {
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    InputColumn& column = data.columns[c];
    column.low = column.high = data.rows.front().x[c];
    for (const DataRow& row : data.rows) {
      column.low = std::min(column.low, row.x[c]);
      column.high = std::max(column.high, row.x[c]);
    }
  }
}

}  // namespace

Result<double> input_value(const std::string& name, const std::string& text, const std::string& unit) {
  if (name == kProfile) {
    const auto at = std::ranges::find(kProfileNames, text);
    if (at == std::end(kProfileNames)) return invalid("unknown profile '" + excerpt(text) + "' (quick, standard or article) use one of those");
    return static_cast<double>(at - std::begin(kProfileNames));
  }
  const Field* field = find_field(name);
  if (!field) return invalid("'" + excerpt(name) + "' is no parameter of a material (nothing would read it) leave it out");
  Report report("", "");
  const Field as_read = under(*field, unit == "1" && field->name.starts_with("eta") ? DampingUnit::kRatio : DampingUnit::kAbsolute);
  const auto value = read_field(as_read, text, unit == "1" ? "" : unit, name, {}, report);
  if (!value) return invalid(report.take().front().text);
  if (field->choices.empty()) return *value;
  const auto at = std::ranges::find(field->choices, static_cast<int>(*value), &Choice::value);
  return static_cast<double>(at - field->choices.begin());
}

Result<std::vector<DataRow>> rows_of(const Source& source, const std::vector<InputColumn>& columns) {
  std::vector<DataRow> out;
  std::vector<std::vector<double>> values;  // [column][level]
  for (const InputColumn& column : columns) {
    auto list = values_of(source, column.name);
    if (!list.ok()) return list.error();
    values.push_back(std::move(*list));
  }
  std::map<int, std::map<std::string, Sum>> sums;  // by point
  std::map<int, std::vector<double>> inputs;
  for (const TableRow& row : source.table.rows) {
    auto& sum = sums[row.point];
    for (const auto& [id, value] : row.value) {
      if (!std::isfinite(value)) {
        return invalid("point " + std::to_string(row.point) + " seed " + std::to_string(row.seed) + ": " + id +
                       " is not a finite number (the table is damaged) run that point again or leave the experiment out");
      }
      sum[id].add(value);
    }
    if (const auto curves = source.curves.find({row.point, row.seed}); curves != source.curves.end()) {
      for (const auto& [id, samples] : curves->second) {
        for (std::size_t k = 0; k < samples.size(); ++k) sum[id + "@" + std::to_string(k)].add(samples[k]);
      }
    }
    std::vector<double> x;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto factor = std::ranges::find(source.table.factors, columns[c].name, &TableFactor::name);
      const bool varies = factor != source.table.factors.end();
      x.push_back(values[c][varies ? static_cast<std::size_t>(row.level[static_cast<std::size_t>(factor - source.table.factors.begin())]) : 0]);
    }
    inputs[row.point] = x;
  }
  for (const auto& [point, sum] : sums) {
    if (sum.empty()) continue;
    DataRow row{.source = source.table.experiment + ", point " + std::to_string(point), .x = inputs[point], .mean = {}};
    for (const auto& [id, s] : sum) row.mean[id] = {s.mean, s.seeds, s.squares};
    out.push_back(std::move(row));
  }
  return out;
}

Result<Dataset> dataset_of(const std::vector<Source>& sources) {
  if (sources.empty()) return invalid("no experiment to learn from (none was named) name one or more");
  Dataset data;
  for (const std::string& name : varied(sources)) {
    if (name != kProfile && !find_field(name)) return input_value(name, "", "").error();
    data.columns.push_back({.name = name, .labels = labels_of(name)});
  }
  for (const Source& source : sources) {
    auto rows = rows_of(source, data.columns);
    if (!rows.ok()) return rows.error();
    for (DataRow& row : *rows) merge(std::move(row), data);
    for (const TableResponse& response : source.table.responses) data.unit[response.id] = response.unit;
  }
  if (data.rows.size() < kFewestRows) {
    return Error{Code::kFailedPrecondition, "only " + std::to_string(data.rows.size()) + " points have numbers (a surrogate needs " +
                                                std::to_string(kFewestRows) + " or more) run more points"};
  }
  for (const auto& [name, text] : sources.front().table.fixed) {
    if (std::ranges::find(data.columns, name, &InputColumn::name) == data.columns.end()) data.fixed[name] = text;
  }
  find_ranges(data);
  return data;
}

bool is_of_the_run(const std::string& column) { return column == kProfile || column == kParticles; }

Inputs inputs_of(const std::vector<InputColumn>& columns, const std::vector<double>& x) {
  std::vector<double> out;
  double grains = 1;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const InputColumn& column = columns[c];
    if (column.name == kParticles && column.high > column.low) {
      grains = x[c] / column.low;
      out.push_back(std::log(grains) / std::log(column.high / column.low));
      continue;
    }
    if (!column.is_choice()) {
      out.push_back(column.high > column.low ? (x[c] - column.low) / (column.high - column.low) : 0.5);
      continue;
    }
    for (std::size_t k = 0; k < column.labels.size(); ++k) out.push_back(static_cast<std::size_t>(x[c]) == k ? 1.0 : 0.0);
  }
  return {Eigen::Map<const Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size())), grains};
}

namespace {

/// A curve's point scatters by per cents: six digits keep the model's file small.
double six_digits(double value) {
  if (!(std::abs(value) > 0)) return value;
  const double unit = std::pow(10, 5 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

}  // namespace

CurveSamples sampled(const std::vector<double>& strain, const std::vector<double>& stress) {
  CurveSamples out;
  for (std::size_t i = 0; i < std::min(strain.size(), stress.size()) && out.size() <= kStrainSteps; ++i) {
    for (double wanted = 0.01 * static_cast<double>(out.size()); out.size() <= kStrainSteps && strain[i] >= wanted - 1e-12;
         wanted = 0.01 * static_cast<double>(out.size())) {
      const double share = i == 0 || strain[i] == wanted ? 1 : (wanted - strain[i - 1]) / (strain[i] - strain[i - 1]);
      out.push_back(six_digits(i == 0 ? stress[0] : stress[i - 1] + share * (stress[i] - stress[i - 1])));
    }
  }
  if (out.size() <= kStrainSteps) out.clear();
  return out;
}

}  // namespace regolab::surrogate
