#include "scheduler/surrogate/fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scheduler/surrogate/curves.h"

namespace regolab::surrogate {
namespace {

constexpr std::string_view kModelled[] = {"contacts_per_particle", "bulk_density",  "void_ratio", "core_density", "repose_angle",
                                          "sigma1_at_sigma3_",     "sigma1_peak_at", "E50_at",    "penetration_force"};

struct Held {
  double measured, predicted, half_width;  // as modelled, before inflation
};

double correlation(const std::vector<Held>& held) {
  double mp = 0, mm = 0;
  for (const Held& h : held) mp += h.predicted, mm += h.measured;
  mp /= static_cast<double>(held.size()), mm /= static_cast<double>(held.size());
  double pm = 0, pp = 0, mm2 = 0;
  for (const Held& h : held) {
    pm += (h.predicted - mp) * (h.measured - mm);
    pp += (h.predicted - mp) * (h.predicted - mp);
    mm2 += (h.measured - mm) * (h.measured - mm);
  }
  return pp > 0 && mm2 > 0 ? pm / std::sqrt(pp * mm2) : 0;
}

Skill skill_of(const std::vector<Held>& held, bool logarithm, double inflation) {
  Skill skill{.points = static_cast<int>(held.size()), .r = correlation(held)};
  double mean = 0, left = 0, all = 0;
  for (const Held& h : held) mean += h.measured / static_cast<double>(held.size());
  for (const Held& h : held) {
    const auto shown = [&](double v) { return logarithm ? std::exp(v) : v; };
    const double error = shown(h.predicted) - shown(h.measured);
    left += (h.predicted - h.measured) * (h.predicted - h.measured);
    all += (h.measured - mean) * (h.measured - mean);
    skill.rms += error * error / static_cast<double>(held.size());
    skill.relative += std::abs(error / shown(h.measured)) / static_cast<double>(held.size());
    skill.coverage += (std::abs(h.predicted - h.measured) <= inflation * h.half_width ? 1.0 : 0.0) / static_cast<double>(held.size());
  }
  skill.rms = std::sqrt(skill.rms);
  skill.r2 = all > 0 ? 1 - left / all : 0;
  return skill;
}

/// Rows of one material, whatever the profile, have one number.
std::vector<int> materials_of(const Dataset& data, const std::vector<std::size_t>& rows) {
  std::map<std::vector<double>, int> known;
  std::vector<int> out;
  for (const std::size_t row : rows) {
    std::vector<double> x;
    for (std::size_t c = 0; c < data.columns.size(); ++c) {
      if (data.columns[c].name != "profile") x.push_back(data.rows[row].x[c]);
    }
    out.push_back(known.try_emplace(std::move(x), static_cast<int>(known.size())).first->second);
  }
  return out;
}

/// The factor that makes bands cover 90 % of what was left out; within bounds, so that a few odd points do not rule.
double inflation_of(const std::vector<Held>& held) {
  std::vector<double> ratio;
  for (const Held& h : held) ratio.push_back(std::abs(h.predicted - h.measured) / h.half_width);
  std::ranges::sort(ratio);
  const auto at = static_cast<std::size_t>(std::ceil(kCoverage * static_cast<double>(ratio.size()))) - 1;
  return std::clamp(ratio[at], 0.7, 2.0);
}

}  // namespace

bool is_modelled(const std::string& response) {
  return response.find('@') == std::string::npos &&
         std::ranges::any_of(kModelled, [&](std::string_view known) { return response.starts_with(known); });
}

bool by_logarithm(const std::string& response) {
  return response.starts_with("sigma1") || response.starts_with("E50") || response.starts_with("penetration_force");
}

Observations observations_of(const Dataset& data, const std::string& response, std::vector<std::size_t>& rows) {
  rows.clear();
  const bool logarithm = by_logarithm(response);
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const auto found = data.rows[i].mean.find(response);
    if (found != data.rows[i].mean.end() && (!logarithm || found->second.value > 0)) rows.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(rows.size());
  Observations out{Eigen::MatrixXd(n, n ? scaled_inputs(data.columns, data.rows[rows[0]].x).size() : 0), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const DataRow& row = data.rows[rows[static_cast<std::size_t>(i)]];
    const SeedMean& mean = row.mean.at(response);
    out.x.row(i) = scaled_inputs(data.columns, row.x).transpose();
    out.y[i] = logarithm ? std::log(mean.value) : mean.value;
    out.seeds[i] = mean.seeds;
  }
  return out;
}

ResponseModel response_model(const Dataset& data, const std::string& response, const Hyperparameters& hyperparameters) {
  std::vector<std::size_t> rows;
  Observations observations = observations_of(data, response, rows);
  ResponseModel model{.id = response,
                      .unit = data.unit.at(response),
                      .logarithm = by_logarithm(response),
                      .rows = std::move(rows),
                      .process = GaussianProcess(std::move(observations), hyperparameters),
                      .skill = {}};
  std::vector<Held> held;
  const auto left_out = model.process.leave_groups_out(materials_of(data, model.rows));
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const auto& p = left_out[i];
    const double noise = p.noise / model.process.observations().seeds[k];
    held.push_back({model.process.observations().y[k], p.mean, kNormal90 * std::sqrt(p.variance + noise)});
  }
  model.inflation = inflation_of(held);
  model.skill = skill_of(held, model.logarithm, model.inflation);
  return model;
}

}  // namespace regolab::surrogate
