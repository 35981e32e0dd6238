#include "scheduler/surrogate/model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "input/field.h"
#include "scheduler/surrogate/curves.h"
#include "scheduler/surrogate/fit.h"

namespace regolab::surrogate {
namespace {

constexpr std::string_view kSigma1 = "sigma1_at_sigma3_";

struct Band {
  double centre, of_mean, of_run;  // as modelled; half widths
};

Band band_of(const ResponseModel& response, const Inputs& x) {
  const auto p = response.predict(x);
  const double own = response.inflation * response.inflation * p.variance;
  return {p.mean, kNormal90 * std::sqrt(own), kNormal90 * std::sqrt(own + p.noise)};
}

Estimate estimate_of(const std::string& id, const std::string& unit, bool logarithm, const Band& b) {
  const auto shown = [&](double v) { return logarithm ? std::exp(v) : v; };
  return {id, unit, shown(b.centre), shown(b.centre - b.of_run), shown(b.centre + b.of_run), shown(b.centre - b.of_mean),
          shown(b.centre + b.of_mean)};
}

}  // namespace

GaussianProcess::Prediction ResponseModel::predict(const Inputs& inputs) const {
  GaussianProcess::Prediction out;
  for (std::size_t k = 0; k < processes.size(); ++k) {
    const auto p = processes[k]->predict(inputs.scaled);
    out.mean += weight[k] * p.mean;
    out.variance += weight[k] * weight[k] * p.variance;
    out.noise += weight[k] * weight[k] * p.noise;
  }
  out.noise = (noise > 0 ? noise : out.noise) * scatter.factor(inputs.scaled) / inputs.grains;
  return out;
}

const ResponseModel* Model::find(const std::string& response) const {
  const auto found = std::ranges::find(responses, response, &ResponseModel::id);
  return found == responses.end() ? nullptr : &*found;
}

Estimate Model::predict_one(const ResponseModel& r, const Inputs& inputs) const {
  return estimate_of(r.id, r.unit, r.logarithm, band_of(r, inputs));
}

std::vector<Estimate> Model::predict(const std::vector<double>& x) const {
  const Inputs inputs = inputs_of(data.columns, x);
  std::vector<Estimate> out;
  for (const ResponseModel& r : responses) out.push_back(predict_one(r, inputs));
  return out;
}

std::optional<Estimate> Model::sigma1_at(const std::vector<double>& x, double sigma3) const {
  std::map<double, const ResponseModel*> known;
  for (const ResponseModel& r : responses) {
    if (const auto at = confining_stress_of(r.id, kSigma1)) known[*at] = &r;
  }
  std::vector<double> stresses;
  for (const auto& [stress, response] : known) stresses.push_back(stress);
  const auto place = between(stresses, sigma3);
  if (!place) return std::nullopt;
  const Inputs inputs = inputs_of(data.columns, x);
  const Band a = band_of(*known.at(stresses[place->low]), inputs);
  if (known.size() == 1) return estimate_of(known.begin()->second->id, "Pa", true, a);
  const Band b = band_of(*known.at(stresses[place->low + 1]), inputs);
  const double w = place->share;
  // Errors at two stresses share their bed: bands add as if fully correlated.
  const auto mix = [w](double p, double q) { return (1 - w) * p + w * q; };
  const Band both{mix(a.centre, b.centre), mix(a.of_mean, b.of_mean), mix(a.of_run, b.of_run)};
  return estimate_of(std::string(kSigma1) + kilopascals(sigma3), "Pa", true, both);
}

std::vector<Estimate> Model::curve_at(const std::vector<double>& x, double sigma3) const {
  if (!curves) return {};
  std::vector<Estimate> out;
  const auto at = curves_at(*curves, inputs_of(data.columns, x), sigma3);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Band band{at[k].mean, kNormal90 * at[k].of_mean, kNormal90 * at[k].of_run};
    out.push_back(estimate_of("sigma1_at_strain_" + std::to_string(k) + "percent", "Pa", true, band));
  }
  return out;
}

std::vector<std::string> Model::outside(const std::vector<double>& x) const {
  std::vector<std::string> out;
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    const InputColumn& column = data.columns[c];
    if (column.is_choice()) {
      const bool seen = std::ranges::any_of(data.rows, [&](const DataRow& row) { return row.x[c] == x[c]; });
      if (!seen) out.push_back(column.name + " = " + column.labels[static_cast<std::size_t>(x[c])] + " (the data have none)");
      continue;
    }
    const double slack = 1e-6 * (column.high - column.low);
    if (x[c] >= column.low - slack && x[c] <= column.high + slack) continue;
    const Field& field = *find_field(column.name);
    const bool below = x[c] < column.low;
    const std::string unit(door_unit_of(field));
    out.push_back(column.name + " = " + door_text(field, x[c]) + (unit == "1" ? "" : " " + unit) + " (the data " +
                  (below ? "begin at " : "end at ") + door_text(field, below ? column.low : column.high) + ")");
  }
  return out;
}

}  // namespace regolab::surrogate
