#include "scheduler/surrogate/curves.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace regolab::surrogate {
namespace {

constexpr std::string_view kCurve = "sigma1_curve_at_sigma3_";
constexpr Eigen::Index kMostComponents = 6;
constexpr double kShareKept = 0.995;  // of the variance
constexpr int kGrid = kStrainSteps + 1;

std::string sample_id(double sigma3, int k) { return std::string(kCurve) + kilopascals(sigma3) + "@" + std::to_string(k); }

std::vector<double> stresses_of(const Dataset& data) {
  std::set<double> found;
  for (const DataRow& row : data.rows) {
    for (const auto& [id, mean] : row.mean) {
      if (!id.ends_with("@0")) continue;
      if (const auto at = confining_stress_of(id.substr(0, id.size() - 2), kCurve)) found.insert(*at);
    }
  }
  return {found.begin(), found.end()};
}

/// Logarithms of all samples of a row; empty when one is missing or not positive.
std::vector<double> logarithms(const DataRow& row, const std::vector<double>& sigma3) {
  std::vector<double> out;
  for (const double stress : sigma3) {
    for (int k = 0; k < kGrid; ++k) {
      const auto found = row.mean.find(sample_id(stress, k));
      if (found == row.mean.end() || !(found->second.value > 0)) return {};
      out.push_back(std::log(found->second.value));
    }
  }
  return out;
}

}  // namespace

std::optional<double> confining_stress_of(const std::string& id, std::string_view prefix) {
  if (!id.starts_with(prefix)) return std::nullopt;
  double kPa = 0;
  const char* begin = id.data() + prefix.size();
  const auto [end, error] = std::from_chars(begin, id.data() + id.size(), kPa);
  if (error != std::errc{} || std::string_view(end, static_cast<std::size_t>(id.data() + id.size() - end)) != "kPa") return std::nullopt;
  return 1000 * kPa;
}

std::string kilopascals(double pascal) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, std::round(pascal) / 1000);
  return std::string(buffer, end.ptr) + "kPa";
}

std::optional<CurveModel> curve_model(const Dataset& data, const Scatter& scatter, const std::function<GaussianProcess(Observations, std::size_t)>& fit) {
  CurveModel model{.sigma3 = stresses_of(data), .mean = {}, .components = {}, .residual = {}, .processes = {}, .scatter = scatter};
  if (model.sigma3.empty()) return std::nullopt;
  std::vector<std::vector<double>> logs;
  std::vector<Inputs> inputs;
  std::vector<int> seeds;
  for (const DataRow& row : data.rows) {
    auto list = logarithms(row, model.sigma3);
    if (list.empty()) continue;
    logs.push_back(std::move(list));
    inputs.push_back(inputs_of(data.columns, row.x));
    seeds.push_back(row.mean.at(sample_id(model.sigma3.front(), 0)).seeds);
  }
  if (logs.size() < kFewestRows) return std::nullopt;
  const auto n = static_cast<Eigen::Index>(logs.size()), width = static_cast<Eigen::Index>(logs.front().size());
  Eigen::MatrixXd y(n, width);
  Observations observations{Eigen::MatrixXd(n, inputs.front().scaled.size()), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    y.row(i) = Eigen::Map<const Eigen::RowVectorXd>(logs[k].data(), width);
    observations.x.row(i) = inputs[k].scaled.transpose();
    observations.runs[i] = seeds[k] * inputs[k].grains / scatter.factor(inputs[k].scaled);
  }
  model.mean = y.colwise().mean().transpose();
  y.rowwise() -= model.mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(y.transpose() * y);
  const Eigen::VectorXd power = axes.eigenvalues().reverse();
  Eigen::Index kept = 1;
  while (kept < std::min(kMostComponents, power.size()) && power.head(kept).sum() < kShareKept * power.sum()) ++kept;
  model.components = axes.eigenvectors().rightCols(kept).rowwise().reverse();
  const Eigen::MatrixXd scores = y * model.components;
  model.residual = ((y - scores * model.components.transpose()).array().square().colwise().sum() / static_cast<double>(n)).sqrt().transpose();
  for (Eigen::Index c = 0; c < kept; ++c) {
    observations.y = scores.col(c);
    model.processes.push_back(fit(observations, static_cast<std::size_t>(c)));
  }
  return model;
}

std::optional<Between> between(const std::vector<double>& sigma3, double at) {
  const double slack = 1e-9 * at;
  if (sigma3.empty() || at < sigma3.front() - slack || at > sigma3.back() + slack) return std::nullopt;
  Between place;
  while (place.low + 2 < sigma3.size() && sigma3[place.low + 1] < at) ++place.low;
  if (sigma3.size() == 1) return place;
  place.share = std::clamp(std::log(at / sigma3[place.low]) / std::log(sigma3[place.low + 1] / sigma3[place.low]), 0.0, 1.0);
  return place;
}

std::vector<CurveValue> curves_at(const CurveModel& model, const Inputs& inputs, double sigma3) {
  const auto place = between(model.sigma3, sigma3);
  if (!place) return {};
  const double w = place->share;
  std::vector<GaussianProcess::Prediction> scores;
  for (const GaussianProcess& process : model.processes) scores.push_back(process.predict(inputs.scaled));
  std::vector<CurveValue> out;
  for (int e = 0; e < kGrid; ++e) {
    const auto at = [&](std::size_t stress) { return static_cast<Eigen::Index>(stress) * kGrid + e; };
    const Eigen::Index a = at(place->low), b = model.sigma3.size() == 1 ? a : at(place->low + 1);
    const auto mix = [&](const auto& values) { return (1 - w) * values(a) + w * values(b); };
    double mean = mix(model.mean), variance = 0, noise = 0;
    const double left = mix(model.residual);
    for (std::size_t c = 0; c < scores.size(); ++c) {
      const double weight = mix(model.components.col(static_cast<Eigen::Index>(c)));
      mean += weight * scores[c].mean;
      variance += weight * weight * scores[c].variance;
      noise += weight * weight * scores[c].noise * model.scatter.factor(inputs.scaled) / inputs.grains;
    }
    out.push_back({mean, std::sqrt(variance), std::sqrt(variance + noise + left * left)});
  }
  return out;
}

}  // namespace regolab::surrogate
