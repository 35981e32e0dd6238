#include "scheduler/surrogate/bp_ann_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "scheduler/analysis/article.h"
#include "vocab/units.h"

namespace regolab::surrogate {
namespace {

constexpr double kGrainDensity = 2930;  // kg/m3 [article Sec. 3.1.3]
constexpr std::string_view kSigma1 = "sigma1_at_sigma3_";

/// Table 11 in door units. Stiffness was normalised in kN/m and damping in per cent: only so do they fall into [0, 1].
struct Constant {
  std::string_view name;
  double constant;
};
constexpr Constant kFrictionAngle{"theta_F", 60}, kNormalStiffness{"K_N", 100e3}, kNormalDamping{"eta_N", 1},
    kTangentialStiffness{"K_T", 100e3}, kTangentialDamping{"eta_T", 1}, kSize{"L_S", 2};
constexpr double kConfiningPressure = 10;  // kPa
/// N_E = 12 means a mixture: a kind, not an amount, so every kind is an input of its own (0 or 1).
constexpr std::string_view kKinds[] = {"2", "4", "6", "mixture"};

struct Recipe {
  std::vector<Constant> factors;
  std::vector<Constant> responses;  // of BP-ANN-3: sigma1 alone, over all its pressures
};

Recipe recipe_of(int function) {
  switch (function) {
    case 1: return {{kFrictionAngle}, {{"contacts_per_particle", 10}, {"bulk_density", 2}, {"void_ratio", 1.5}}};
    case 2: return {{kFrictionAngle, kNormalStiffness, kTangentialDamping}, {{"repose_angle", 50}}};
    default:
      return {{kFrictionAngle, kNormalStiffness, kNormalDamping, kTangentialStiffness, kTangentialDamping, kSize},
              {{"sigma1", 250}}};
  }
}

std::string name_of(int function) { return "BP-ANN-" + std::to_string(function); }

Error refused(std::string text) { return {Code::kFailedPrecondition, std::move(text)}; }

/// The whole of `text` as a finite number.
std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A response of the table that the function learns, with the confining pressure it was measured at.
struct Source {
  std::string id;
  double factor = 1;    ///< SI to normalised
  double pressure = 0;  ///< kPa
};

/// One test, its seeds averaged.
struct Point {
  std::vector<int> level;              // [n_factors of the table]
  std::map<std::string, double> mean;  ///< response id -> SI
};

class TableReader {
 public:
  TableReader(const ResultTable& table, int function) : table_(table), function_(function), recipe_(recipe_of(function)) {}

  Result<AnnData> read() {
    if (auto found = find_factors(); !found.ok()) return found.error();
    if (auto found = find_sources(); !found.ok()) return found.error();
    if (auto averaged = average(); !averaged.ok()) return averaged.error();
    for (const auto& [point, cells] : points_) {
      if (auto added = add(point, cells); !added.ok()) return added.error();
    }
    return pack();
  }

 private:
  Result<void> find_factors() {
    for (const Constant& wanted : recipe_.factors) {
      if (auto found = find_factor(std::string(wanted.name)); !found.ok()) return found;
      data_.inputs.emplace_back(wanted.name);
    }
    if (auto found = find_factor("N_E"); !found.ok()) return found;
    for (const std::string_view kind : kKinds) data_.inputs.push_back("N_E=" + std::string(kind));
    if (function_ == 3) data_.inputs.push_back("sigma3");
    return {};
  }

  Result<void> find_factor(const std::string& name) {
    const auto at = std::ranges::find(table_.factors, name, &TableFactor::name);
    if (at != table_.factors.end()) {
      column_.push_back(static_cast<std::size_t>(at - table_.factors.begin()));
      return {};
    }
    const auto fixed = table_.fixed.find(name);
    const std::string why = fixed == table_.fixed.end() ? "it is not among the factors" : "it is fixed at " + fixed->second;
    return refused("experiment " + table_.experiment + " does not vary " + name + " (" + why + ", and " +
                   name_of(function_) + " takes it in) name an experiment with " + name + " among its factors");
  }

  Result<void> find_sources() {
    for (const TableResponse& response : table_.responses) {
      const double door = door_unit(response.unit).factor;
      if (function_ == 3) {
        if (!response.id.starts_with(kSigma1) || !response.id.ends_with("kPa")) continue;
        const std::string_view id = response.id;
        const auto pressure = number_in(id.substr(kSigma1.size(), id.size() - kSigma1.size() - 3));
        if (pressure) sources_.push_back({response.id, door / recipe_.responses.front().constant, *pressure});
      }
    }
    if (function_ == 3) {
      if (sources_.empty()) return no_response("sigma1", "stress");
      data_.outputs.push_back({"sigma1", "kPa", recipe_.responses.front().constant});
      return {};
    }
    for (const Constant& wanted : recipe_.responses) {
      const auto at = std::ranges::find(table_.responses, wanted.name, &TableResponse::id);
      if (at == table_.responses.end()) return no_response(std::string(wanted.name), function_ == 2 ? "repose" : "density");
      const DoorUnit door = door_unit(at->unit);
      sources_.push_back({at->id, door.factor / wanted.constant, 0});
      data_.outputs.push_back({at->id, std::string(door.name), wanted.constant});
    }
    return {};
  }

  Error no_response(const std::string& response, const std::string& test) const {
    return refused("experiment " + table_.experiment + " has no " + response + " (its tests do not measure it, and " +
                   name_of(function_) + " predicts it) name an experiment with the test `" + test + "`");
  }

  Result<void> average() {
    std::map<int, std::map<std::string, int>> count;
    for (const TableRow& row : table_.rows) {
      Point& point = points_[row.point];
      point.level = row.level;
      for (const Source& source : sources_) {
        const auto value = row.value.find(source.id);
        if (value == row.value.end()) continue;
        if (!std::isfinite(value->second)) {
          return Error{Code::kDataLoss,
                       "point " + std::to_string(row.point) + " seed " + std::to_string(row.seed) + " of experiment " +
                           table_.experiment + ": " + source.id +
                           " is not a number (nan or infinite cannot be learnt) take that run out or repeat it"};
        }
        const int n = ++count[row.point][source.id];
        double& mean = point.mean[source.id];
        mean += (value->second - mean) / n;
      }
    }
    return {};
  }

  /// Normalised factors of a point, then the kinds. [n_inputs without sigma3]
  Result<std::vector<double>> inputs_of(int point, const std::vector<int>& level) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < column_.size(); ++i) {
      const TableFactor& factor = table_.factors[column_[i]];
      const int index = column_[i] < level.size() ? level[column_[i]] : -1;
      const bool known = index >= 0 && static_cast<std::size_t>(index) < factor.levels.size();
      const std::string label = known ? factor.levels[static_cast<std::size_t>(index)] : "";
      if (i < recipe_.factors.size()) {
        const auto number = number_in(label);
        if (!number) return bad_label(point, factor.name, label, "a number");
        values.push_back(*number / recipe_.factors[i].constant);
        continue;
      }
      if (std::ranges::find(kKinds, label) == std::end(kKinds)) return bad_label(point, "N_E", label, "2, 4, 6 or mixture");
      for (const std::string_view kind : kKinds) values.push_back(kind == label ? 1 : 0);
    }
    return values;
  }

  Error bad_label(int point, const std::string& factor, const std::string& label, const std::string& wanted) const {
    return refused("point " + std::to_string(point) + " of experiment " + table_.experiment + ": " + factor + " is `" +
                   label + "` (" + wanted + " is wanted) correct the design");
  }

  Result<void> add(int point, const Point& cells) {
    auto inputs = inputs_of(point, cells.level);
    if (!inputs.ok()) return inputs.error();
    if (function_ == 3) {
      for (const Source& source : sources_) {
        const auto value = cells.mean.find(source.id);
        if (value == cells.mean.end()) continue;
        std::vector<double> row = *inputs;
        row.push_back(source.pressure / kConfiningPressure);
        keep(point, std::move(row), {value->second * source.factor});
      }
      return {};
    }
    std::vector<double> outputs;
    for (const Source& source : sources_) {
      const auto value = cells.mean.find(source.id);
      if (value != cells.mean.end()) outputs.push_back(value->second * source.factor);
    }
    if (outputs.size() == sources_.size()) keep(point, std::move(*inputs), std::move(outputs));
    return {};
  }

  void keep(int point, std::vector<double> inputs, std::vector<double> outputs) {
    data_.test.push_back(point);
    x_.push_back(std::move(inputs));
    y_.push_back(std::move(outputs));
  }

  Result<AnnData> pack() {
    const auto tests = std::set<int>(data_.test.begin(), data_.test.end()).size();
    if (tests < static_cast<std::size_t>(kFewestTests)) {
      return refused(name_of(function_) + " has only " + std::to_string(tests) +
                     " tests with all its numbers in experiment " + table_.experiment + " (" + std::to_string(kFewestTests) +
                     " are needed to train, validate and test) wait until more is done, or name a larger experiment");
    }
    data_.x = matrix_of(x_);
    data_.y = matrix_of(y_);
    return std::move(data_);
  }

  static Eigen::MatrixXd matrix_of(const std::vector<std::vector<double>>& rows) {
    Eigen::MatrixXd matrix(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      matrix.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), matrix.cols());
    return matrix;
  }

  const ResultTable& table_;
  const int function_;
  const Recipe recipe_;
  std::vector<std::size_t> column_;  // of the table: the recipe's factors, then N_E
  std::vector<Source> sources_;
  std::map<int, Point> points_;
  std::vector<std::vector<double>> x_, y_;
  AnnData data_;
};

}  // namespace

Result<AnnData> ann_data(const ResultTable& table, int function) {
  if (function < 1 || function > 3)
    return invalid(name_of(function) + " (the article has BP-ANN-1, -2 and -3) name one of them");
  return TableReader(table, function).read();
}

ResultTable article_training_table() {
  ResultTable table = analysis::article_results();
  for (TableRow& row : table.rows) row.value["void_ratio"] = kGrainDensity / row.value.at("bulk_density") - 1;
  return table;
}

}  // namespace regolab::surrogate
