#include "scheduler/gap/emulator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "scheduler/gap/covariances.h"
#include "scheduler/gap/repeats.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kFewestMaterials = 20;
constexpr std::size_t kFewestOfEffect = 8;
constexpr double kLeastError = 0.1;       // of one run's variance: below, the difference of two estimates is chance
constexpr double kErrorShrinkage = 0.1;
constexpr double kLeastVariance = 1e-12;  // effects that need no DEM scatter by nothing
// Errors of shifts go together as those of runs left out do, and as seeds do, half and half: what 73 development cases were likeliest under
// (mean log density at the truth, effects alone: 104 with the base model's correlation, 107 with none, 112 with either, 113 with both).
constexpr double kAsSeeds = 0.5;

/// Features that one kernel serves: they answer to the same parameters.
int family_of(const FeatureInfo& f) {
  constexpr int kStoodOrSlid = 6;  // of every bed, also where there is no slope
  if (f.group.test != Test::kStress) return f.id == "repose_column_stood" || f.id == "repose_wedge" ? kStoodOrSlid : static_cast<int>(f.group.test);
  switch (f.group.part) {
    case Part::kSeating:
    case Part::kVolume: return 3 + 4;
    case Part::kStiffness:
    case Part::kEarly: return 3 + 5;
    case Part::kLateral: return 3 + 6;
    default: return 3 + 7;
  }
}

std::vector<std::vector<Index>> families_of(const std::vector<FeatureInfo>& features) {
  std::map<int, std::vector<Index>> by_family;
  for (std::size_t j = 0; j < features.size(); ++j) by_family[family_of(features[j])].push_back(static_cast<Index>(j));
  std::vector<std::vector<Index>> out;
  for (auto& [family, members] : by_family) out.push_back(std::move(members));
  return out;
}

VectorXd values_of(const Bank& bank, const BankRow& row, const Space& space) {
  VectorXd out(static_cast<Index>(space.size()));
  for (std::size_t k = 0; k < space.size(); ++k) out[static_cast<Index>(k)] = row.inputs[*bank.input(space.axes[k].name)];
  return out;
}

/// Index of the one cause that a row has; -1: none, -2: several, or one that is no hypothesis.
int cause_of(const Bank& bank, const BankRow& row, const std::vector<Cause>& causes) {
  int found = -1;
  for (std::size_t i = 0; i < bank.inputs.size(); ++i) {
    if (row.inputs[i] == 0 || !find_effect(bank.inputs[i].name)) continue;
    const auto cause = std::ranges::find(causes, find_effect(bank.inputs[i].name), &Cause::effect);
    if (found != -1 || cause == causes.end()) return -2;
    found = static_cast<int>(cause - causes.begin());
  }
  return found;
}

bool complete(const MatrixXd& y, Index row, const std::vector<Index>& members) {
  return std::ranges::all_of(members, [&](Index j) { return std::isfinite(y(row, j)); });
}

/// Rows of a sample that hold every member.
std::vector<Index> rows_with(const std::vector<Index>& members, const MatrixXd& y) {
  std::vector<Index> rows;
  for (Index i = 0; i < y.rows(); ++i) {
    if (complete(y, i, members)) rows.push_back(i);
  }
  return rows;
}

Sample part_of(const MatrixXd& x, const MatrixXd& y, const VectorXd& weight, const std::vector<Index>& rows, const std::vector<Index>& members) {
  return {x(rows, Eigen::all), y(rows, members), VectorXd(weight(rows))};
}

/// Variance between repeats of each material over the mean's, of these features together.
VectorXd scale_of(const Repeats& base, const std::vector<Index>& members) {
  VectorXd sum = VectorXd::Zero(base.squares.rows()), count = sum;
  for (const Index j : members) {
    for (Index i = 0; i < sum.size(); ++i) {
      if (std::isfinite(base.squares(i, j))) sum[i] += base.squares(i, j) / base.noise[j], ++count[i];
    }
  }
  return sum.array() / count.array();
}

/// Covariance of what a process gets wrong about rows left out, seeds apart. residual: [n][p]; seeds: [p] variance that they have in it.
MatrixXd beyond_seeds(const MatrixXd& residual, const VectorXd& seeds, const MatrixXd& correlation) {
  const VectorXd sd = seeds.cwiseSqrt();
  return paired_covariance(residual) - sd.asDiagonal() * correlation * sd.asDiagonal();
}

MatrixXd correlation_of_errors(const MatrixXd& residual, const VectorXd& seeds, const MatrixXd& correlation) {
  const MatrixXd wrong = beyond_seeds(residual, seeds, correlation);
  return sound_correlation(wrong, wrong.diagonal().cwiseMax(kLeastError * seeds).cwiseMax(kLeastVariance), kErrorShrinkage);
}

}  // namespace

double Cause::strength(double u) const {
  const double low = effect->prior_low, high = effect->prior_high;
  return effect->logarithmic ? low * std::pow(high / low, u) : low + (high - low) * u;
}

double Cause::share(double strength) const {
  const double low = effect->prior_low, high = effect->prior_high;
  return effect->logarithmic ? std::log(std::max(strength, low / 10) / low) / std::log(high / low) : (strength - low) / (high - low);
}

double Cause::growth(double strength) const {
  const double low = effect->prior_low, high = effect->prior_high;
  if (effect->id == EffectId::kLoadingRate) return std::expm1(std::numbers::ln10 * strength) / std::expm1(std::numbers::ln10 * high);  // decades of speed
  if (!effect->logarithmic) return strength / std::max(std::abs(low), std::abs(high));
  const double middle = std::pow(low, 0.75) * std::pow(high, 0.25);  // proportional below, by ratios above
  return std::log1p(strength / middle) / std::log1p(high / middle);
}

int Emulator::feature(const std::string& id) const {
  const auto found = std::ranges::find(features_, id, &FeatureInfo::id);
  return found == features_.end() ? -1 : static_cast<int>(found - features_.begin());
}

Result<Emulator> Emulator::from(const Bank& all, const std::vector<Kernel>& kernels) {
  Emulator out;
  const double usual = usual_size(all);
  const Bank bank = of_size(all, usual);
  out.space_ = space_of(bank);
  for (const std::string& id : bank.features) {
    if (const auto info = feature_info(id)) out.features_.push_back(*info);
  }
  for (const BankInput& input : bank.inputs) {
    const EffectInfo* effect = find_effect(input.name);
    if (effect && !effect->variant_of) out.causes_.push_back({effect});
  }
  const Repeats base = repeats_without_effects(bank, out.space_);
  if (base.mean.rows() < static_cast<Index>(kFewestMaterials)) {
    return Error{Code::kFailedPrecondition, "the bank has " + std::to_string(base.mean.rows()) + " materials without effects (emulators need " +
                                                std::to_string(kFewestMaterials) + ") run more"};
  }
  std::size_t used = 0;
  const Process process = [&](Sample sample, const Groups& groups) {
    const Kernel kernel = used < kernels.size() ? kernels[used] : fit_kernel(sample, groups);
    ++used;
    return std::make_shared<const SharedGp>(std::move(sample), kernel);
  };
  out.learn_base(base, process);
  out.compare_sizes(all, usual);
  std::vector<Cause> known;
  for (std::size_t c = 0; c < out.causes_.size(); ++c) {
    std::vector<const BankRow*> rows;
    for (const BankRow& row : bank.rows) {
      if (cause_of(bank, row, out.causes_) == static_cast<int>(c)) rows.push_back(&row);
    }
    if (rows.size() < kFewestOfEffect) continue;
    known.push_back(out.causes_[c]);
    out.effects_.push_back(out.learn_effect(bank, rows, out.causes_[c], process));
  }
  out.causes_ = std::move(known);
  return out;
}

void Emulator::learn_base(const Repeats& base, const Process& process) {
  noise_ = base.noise, correlation_ = base.correlation;
  const MatrixXd x = space_.scaled(base.values);
  MatrixXd residual = MatrixXd::Constant(base.mean.rows(), base.mean.cols(), NAN), foretold = residual;
  for (const auto& members : families_of(features_)) {
    const auto rows = rows_with(members, base.mean);
    const NoiseScale scale(x, scale_of(base, members));
    const VectorXd weight = base.weight.array() / scale.at(x).array();
    Family family{members, process(part_of(x, base.mean, weight, rows, members), space_.groups()), scale};
    const Predicted left_out = family.gp->leave_one_out();
    residual(rows, members) = base.mean(rows, members) - left_out.mean.transpose();
    foretold(rows, members) = left_out.variance.transpose();
    base_.push_back(std::move(family));
  }
  judge(residual, foretold, base.weight.mean());
}

/// From rows with this cause alone: what their shifts would be at full growth, known the worse the weaker the effect was.
Emulator::Effect Emulator::learn_effect(const Bank& bank, const std::vector<const BankRow*>& rows, const Cause& cause, const Process& process) const {
  const auto n = static_cast<Index>(rows.size());
  const std::size_t strength = *bank.input(std::string(cause.effect->name));
  MatrixXd values(static_cast<Index>(space_.size()), n), shift(n, noise_.size());
  for (Index i = 0; i < n; ++i) {
    const BankRow& row = *rows[static_cast<std::size_t>(i)];
    values.col(i) = values_of(bank, row, space_);
    shift.row(i) = Eigen::Map<const VectorXd>(row.features.data(), noise_.size()).transpose();
  }
  shift -= predict(values).mean.transpose();
  MatrixXd x = space_.scaled(values, 1);
  VectorXd weight(n);
  for (Index i = 0; i < n; ++i) {
    const double s = rows[static_cast<std::size_t>(i)]->inputs[strength], g = cause.growth(s);
    x(i, x.cols() - 1) = cause.share(s);
    shift.row(i) /= g;
    weight[i] = g * g;
  }
  Effect effect{.families = {}, .scatter = VectorXd::Zero(noise_.size()), .error_correlation = {}};
  MatrixXd wrong = MatrixXd::Constant(n, noise_.size(), NAN);  // of one run's weight
  VectorXd run = noise_;
  const MatrixXd material = space_.scaled(values);
  for (const Family& base : base_) {
    const auto& members = base.members;
    const VectorXd calm = weight.array() / base.scale.at(material).array();
    const auto present = rows_with(members, shift);
    if (present.size() < kFewestOfEffect) continue;
    effect.families.push_back({members, process(part_of(x, shift, calm, present, members), space_.groups(1)), {}});
    const SharedGp& gp = *effect.families.back().gp;
    run(members) = gp.noise();
    wrong(present, members) = VectorXd(calm(present)).cwiseSqrt().asDiagonal() * (shift(present, members) - gp.leave_one_out().mean.transpose());
    effect.scatter(members) = (gp.noise() - noise_(members)).cwiseMax(0.0) / gp.sample().weight.mean();
  }
  effect.error_correlation = (1 - kAsSeeds) * correlation_of_errors(wrong, run, correlation_) + kAsSeeds * correlation_;
  return effect;
}

/// Runs without effects of other sizes than the usual one, beside what the base processes foretell of their materials.
void Emulator::compare_sizes(const Bank& bank, double usual) {
  const auto input = bank.input("particles");
  std::vector<const BankRow*> rows;
  for (const BankRow& row : bank.rows) {
    if (input && row.inputs[*input] != usual && cause_of(bank, row, causes_) == -1) rows.push_back(&row);
  }
  if (rows.empty()) return;
  const auto n = static_cast<Index>(rows.size());
  MatrixXd values(static_cast<Index>(space_.size()), n), residual(n, noise_.size());
  VectorXd particles(n);
  for (Index i = 0; i < n; ++i) {
    const BankRow& row = *rows[static_cast<std::size_t>(i)];
    values.col(i) = values_of(bank, row, space_), particles[i] = row.inputs[*input];
    residual.row(i) = Eigen::Map<const VectorXd>(row.features.data(), noise_.size()).transpose();
  }
  const Predicted own = predict(values);
  const MatrixXd seeds = noise_.asDiagonal() * noise_scale(values) * (usual / particles.array()).matrix().asDiagonal();
  size_ = FiniteSize(usual, particles, residual - own.mean.transpose(), (own.variance + seeds).transpose());
}

/// What the processes get wrong about materials left out, seeds apart: variance that they did not foretell becomes misfit, and errors of
/// several features that go together are counted once. residual, foretold: [n_materials][p]; runs: behind each material's mean.
void Emulator::judge(const MatrixXd& residual, const MatrixXd& foretold, double runs) {
  const MatrixXd wrong = beyond_seeds(residual, noise_ / runs, correlation_);
  const MatrixXd filled = foretold.array().isFinite().select(foretold, 0.0);
  const VectorXd expected = (filled.colwise().sum().array() / foretold.array().isFinite().cast<double>().colwise().sum().max(1.0)).transpose();
  misfit_ = (wrong.diagonal() - expected).cwiseMax(0.0);
  error_correlation_ = sound_correlation(wrong, wrong.diagonal().cwiseMax(kLeastError * noise_), kErrorShrinkage);
}

Predicted Emulator::predict(const MatrixXd& values, std::span<const Use> uses) const {
  const auto p = static_cast<Index>(features_.size());
  Predicted out{MatrixXd::Zero(p, values.cols()), misfit_.replicate(1, values.cols())};
  const MatrixXd x = space_.scaled(values);
  for (const Family& family : base_) {
    const Predicted part = family.gp->predict(x);
    out.mean(family.members, Eigen::all) += part.mean;
    out.variance(family.members, Eigen::all) += part.variance;
  }
  for (const Use& use : uses) {
    const Predicted more = shift(values, use);
    out.mean += more.mean, out.variance += more.variance;
  }
  return out;
}

Predicted Emulator::shift(const MatrixXd& values, const Use& use) const {
  const auto p = static_cast<Index>(features_.size());
  Predicted out{MatrixXd::Zero(p, values.cols()), MatrixXd::Zero(p, values.cols())};
  const Cause& cause = causes_[use.cause];
  MatrixXd with = space_.scaled(values, 1);
  Eigen::RowVectorXd growth(values.cols());
  for (Index i = 0; i < values.cols(); ++i) with(i, with.cols() - 1) = cause.share(use.strength[i]), growth[i] = cause.growth(use.strength[i]);
  for (const Family& family : effects_[use.cause].families) {
    const Predicted part = family.gp->predict(with);
    out.mean(family.members, Eigen::all) = part.mean * growth.asDiagonal();
    out.variance(family.members, Eigen::all) = part.variance * growth.array().square().matrix().asDiagonal();
  }
  return out;
}

MatrixXd Emulator::noise_scale(const MatrixXd& values) const {
  MatrixXd out(static_cast<Index>(features_.size()), values.cols());
  const MatrixXd x = space_.scaled(values);
  for (const Family& family : base_) out(family.members, Eigen::all) = family.scale.at(x).transpose().replicate(static_cast<Index>(family.members.size()), 1);
  return out;
}

std::vector<Kernel> Emulator::kernels() const {
  std::vector<Kernel> out;
  for (const Family& f : base_) out.push_back(f.gp->kernel());
  for (const Effect& e : effects_) {
    for (const Family& f : e.families) out.push_back(f.gp->kernel());
  }
  return out;
}

}  // namespace regolab::gap
