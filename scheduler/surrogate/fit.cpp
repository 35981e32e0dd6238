#include "scheduler/surrogate/fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "scheduler/surrogate/curves.h"

namespace regolab::surrogate {
namespace {

constexpr std::string_view kModelled[] = {"contacts_per_particle", "bulk_density", "void_ratio", "core_density",
                                           "repose_angle", "repose_angle_wedge", "repose_angle_whole"};
constexpr std::string_view kModelledFamilies[] = {"sigma1_at_sigma3_", "sigma1_peak_at", "E50_at", "penetration_"};

constexpr int kFolds = 10;
constexpr double kLeastInflation = 0.5, kMostInflation = 3;

struct Held {
  double measured, predicted;  // as modelled
  double variance, noise;      // of the prediction before inflation; of the measured mean
  int fold = 0;                // of its material
  bool within(double inflation) const { return std::abs(predicted - measured) <= kNormal90 * std::sqrt(inflation * inflation * variance + noise); }
  /// Square of the inflation that would just reach it.
  double needed() const {
    const double off = (predicted - measured) / kNormal90;
    return std::max(0.0, off * off - noise) / variance;
  }
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

/// The factor that makes bands cover 90 % of what was left out, those of one fold apart; within bounds, so that a few odd points do not rule.
double inflation_of(const std::vector<Held>& held, int without = -1) {
  std::vector<double> ratio;
  for (const Held& h : held) {
    if (h.fold != without) ratio.push_back(h.needed());
  }
  if (ratio.empty()) return 1;
  std::ranges::sort(ratio);
  const auto at = static_cast<std::size_t>(std::ceil(kCoverage * static_cast<double>(ratio.size()))) - 1;
  return std::clamp(std::sqrt(ratio[at]), kLeastInflation, kMostInflation);
}

/// Share inside bands whose width was set by the other folds: a width set by all would cover 90 % whatever it is worth.
double coverage_of(const std::vector<Held>& held) {
  double within = 0;
  for (int fold = 0; fold < kFolds; ++fold) {
    const double inflation = inflation_of(held, fold);
    for (const Held& h : held) within += h.fold == fold && h.within(inflation) ? 1 : 0;
  }
  return within / static_cast<double>(held.size());
}

Skill skill_of(const std::vector<Held>& held, bool logarithm) {
  Skill skill{.points = static_cast<int>(held.size()), .r = correlation(held), .coverage = coverage_of(held)};
  double mean = 0, left = 0, all = 0;
  for (const Held& h : held) mean += h.measured / static_cast<double>(held.size());
  for (const Held& h : held) {
    const auto shown = [&](double v) { return logarithm ? std::exp(v) : v; };
    const double error = shown(h.predicted) - shown(h.measured);
    left += (h.predicted - h.measured) * (h.predicted - h.measured);
    all += (h.measured - mean) * (h.measured - mean);
    skill.rms += error * error / static_cast<double>(held.size());
    skill.relative += std::abs(error / shown(h.measured)) / static_cast<double>(held.size());
  }
  skill.rms = std::sqrt(skill.rms);
  skill.r2 = all > 0 ? 1 - left / all : 0;
  return skill;
}

/// Rows of one material, whatever the profile and the specimen, have one number.
std::vector<int> materials_of(const Dataset& data, const std::vector<std::size_t>& rows) {
  std::map<std::vector<double>, int> known;
  std::vector<int> out;
  for (const std::size_t row : rows) {
    std::vector<double> x;
    for (std::size_t c = 0; c < data.columns.size(); ++c) {
      if (!is_of_the_run(data.columns[c].name)) x.push_back(data.rows[row].x[c]);
    }
    out.push_back(known.try_emplace(std::move(x), static_cast<int>(known.size())).first->second);
  }
  return out;
}

}  // namespace

bool is_modelled(const std::string& response) {
  return response.find('@') == std::string::npos &&
         (std::ranges::find(kModelled, response) != std::end(kModelled) ||
          std::ranges::any_of(kModelledFamilies, [&](std::string_view known) { return response.starts_with(known); }));
}

bool by_logarithm(const std::string& response) {
  return response.starts_with("sigma1") || response.starts_with("E50") || response.starts_with("penetration_");
}

namespace {

/// "sigma1_at_sigma3_" and 2500 Pa of "sigma1_at_sigma3_2.5kPa", "void_ratio_compressed_2.5kPa"; empty without a stress at the end.
std::optional<std::pair<std::string, double>> split(const std::string& id) {
  const auto at = id.rfind('_');
  if (at == std::string::npos || !id.ends_with("kPa")) return std::nullopt;
  const std::string prefix = id.substr(0, at + 1);
  const auto stress = confining_stress_of(id, prefix);
  return stress ? std::optional(std::pair(prefix, *stress)) : std::nullopt;
}

/// Orthonormal polynomials in the logarithm of the stress: level, slope, curvature, ...
Eigen::MatrixXd contrasts(const std::vector<double>& stress) {
  const auto m = static_cast<Eigen::Index>(stress.size());
  Eigen::MatrixXd powers(m, m);
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index k = 0; k < m; ++k) powers(j, k) = std::pow(std::log(stress[static_cast<std::size_t>(j)] / stress[0]), static_cast<double>(k));
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(powers);
  return Eigen::MatrixXd(qr.householderQ());
}

double modelled(const DataRow& row, const std::string& response) {
  const double value = row.mean.at(response).value;
  return by_logarithm(response) ? std::log(value) : value;
}

bool holds(const DataRow& row, const std::vector<std::string>& members) {
  return std::ranges::all_of(members, [&](const std::string& id) {
    const auto found = row.mean.find(id);
    return found != row.mean.end() && (!by_logarithm(id) || found->second.value > 0);
  });
}

bool differs(const Dataset& data, const Family& family) {
  const std::string& id = family.members.front();
  return std::ranges::any_of(family.rows, [&](std::size_t r) { return modelled(data.rows[r], id) != modelled(data.rows[family.rows[0]], id); });
}

}  // namespace

std::vector<Family> families_of(const Dataset& data) {
  std::map<std::string, std::vector<std::pair<double, std::string>>> grouped;
  for (const auto& [id, unit] : data.unit) {
    if (!is_modelled(id)) continue;
    if (const auto parts = split(id)) grouped[parts->first + "*"].emplace_back(parts->second, id);
    else grouped[id].emplace_back(1.0, id);
  }
  std::vector<Family> out;
  for (auto& [name, members] : grouped) {
    std::ranges::sort(members);
    Family family{.name = name, .members = {}, .contrast = {}, .rows = {}};
    std::vector<double> stress;
    for (const auto& [at, id] : members) stress.push_back(at), family.members.push_back(id);
    family.contrast = contrasts(stress);
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
      if (holds(data.rows[i], family.members)) family.rows.push_back(i);
    }
    if (family.rows.size() >= kFewestRows && differs(data, family)) out.push_back(std::move(family));
  }
  return out;
}

namespace {

/// The seeds of a row about their mean, over some members, for the smallest specimen.
Repeats repeats_of(const Dataset& data, const DataRow& row, const std::vector<std::string>& members) {
  const Inputs inputs = inputs_of(data.columns, row.x);
  Repeats out{.scaled = inputs.scaled};
  for (const std::string& id : members) {
    const SeedMean& m = row.mean.at(id);
    const double unit = by_logarithm(id) ? m.value : 1;  // a small deviation of the logarithm is a relative one
    out.variance += m.squares / (unit * unit) * inputs.grains;
    out.freedom += m.seeds - 1;
  }
  if (out.freedom > 0) out.variance /= out.freedom;
  return out;
}

/// Variance of one run of the average material; 0 without repeats.
double noise_of(const Dataset& data, const Family& family, const std::string& member) {
  double sum = 0, freedom = 0;
  for (const std::size_t r : family.rows) {
    const Repeats one = repeats_of(data, data.rows[r], {member});
    if (one.freedom <= 0) continue;
    sum += one.freedom * one.variance / family.scatter.factor(one.scaled);
    freedom += one.freedom;
  }
  return freedom > 0 ? sum / freedom : 0;
}

}  // namespace

Scatter scatter_of(const Dataset& data, const Family& family) {
  std::vector<Repeats> repeats;
  for (const std::size_t r : family.rows) {
    Repeats one = repeats_of(data, data.rows[r], family.members);
    if (one.freedom > 0) repeats.push_back(std::move(one));
  }
  return fit_scatter(repeats);
}

Observations observations_of(const Dataset& data, const Family& family, std::size_t k) {
  const auto n = static_cast<Eigen::Index>(family.rows.size());
  Observations out{Eigen::MatrixXd(n, inputs_of(data.columns, data.rows[family.rows[0]].x).scaled.size()), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const DataRow& row = data.rows[family.rows[static_cast<std::size_t>(i)]];
    const Inputs inputs = inputs_of(data.columns, row.x);
    out.x.row(i) = inputs.scaled.transpose();
    out.y[i] = 0;
    for (std::size_t j = 0; j < family.members.size(); ++j) {
      out.y[i] += family.contrast(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) * modelled(row, family.members[j]);
    }
    out.runs[i] = row.mean.at(family.members.front()).seeds * inputs.grains / family.scatter.factor(inputs.scaled);
  }
  return out;
}

std::vector<ResponseModel> response_models(const Dataset& data, const Family& family, const std::vector<Hyperparameters>& hyperparameters) {
  std::vector<std::shared_ptr<const GaussianProcess>> processes;
  for (std::size_t k = 0; k < family.members.size(); ++k) {
    processes.push_back(std::make_shared<const GaussianProcess>(observations_of(data, family, k), hyperparameters.at(k)));
  }
  std::vector<ResponseModel> out;
  for (std::size_t j = 0; j < family.members.size(); ++j) {
    const std::string& id = family.members[j];
    ResponseModel model{.id = id, .unit = data.unit.at(id), .logarithm = by_logarithm(id), .family = family.name, .weight = {}, .processes = processes, .scatter = family.scatter, .skill = {}};
    for (std::size_t k = 0; k < processes.size(); ++k) model.weight.push_back(family.contrast(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)));
    out.push_back(std::move(model));
  }
  return out;
}

void judge(const Dataset& data, const Family& family, std::vector<ResponseModel>& members) {
  std::vector<std::vector<GaussianProcess::Prediction>> left_out;  // [process][row]
  const std::vector<int> materials = materials_of(data, family.rows);
  for (const auto& process : members.front().processes) left_out.push_back(process->leave_groups_out(materials));
  for (ResponseModel& model : members) {
    model.noise = noise_of(data, family, model.id);
    std::vector<Held> held;
    for (std::size_t i = 0; i < family.rows.size(); ++i) {
      const DataRow& row = data.rows[family.rows[i]];
      const Inputs inputs = inputs_of(data.columns, row.x);
      const double runs = row.mean.at(model.id).seeds * inputs.grains / model.scatter.factor(inputs.scaled);
      double mean = 0, variance = 0, noise = 0;
      for (std::size_t k = 0; k < left_out.size(); ++k) {
        const auto& p = left_out[k][i];
        mean += model.weight[k] * p.mean;
        variance += model.weight[k] * model.weight[k] * p.variance;
        noise += model.weight[k] * model.weight[k] * p.noise;
      }
      held.push_back({modelled(row, model.id), mean, variance, (model.noise > 0 ? model.noise : noise) / runs, materials[i] % kFolds});
    }
    model.inflation = inflation_of(held);
    model.skill = skill_of(held, model.logarithm);
  }
}

}  // namespace regolab::surrogate
