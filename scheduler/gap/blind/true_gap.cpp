#include "scheduler/gap/blind/true_gap.h"

#include <algorithm>
#include <map>

#include "scheduler/gap/blind/report_case.h"
#include "scheduler/gap/tangent.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double choice_number(const std::string& name) {
  static const std::map<std::string, double> kNumbers{{"2", 2}, {"4", 4}, {"6", 6}, {"mixture", 12}, {"none", 0}, {"x", 1}, {"z", 2}, {"xz", 3}};
  const auto found = kNumbers.find(name);
  return found == kNumbers.end() ? 0 : found->second;
}

/// The truth in the unit cube of the base model, which has the axes that nobody states exactly.
VectorXd place_of(const BlindMaterial& m, const Space& space, const std::map<std::string, Stated>& stated) {
  const std::map<std::string, double> si{
      {"theta_F", m.friction_deg * kDegree},  {"K_N", m.normal_stiffness}, {"eta_N", m.normal_damping}, {"K_T", m.tangential_stiffness},
      {"eta_T", m.tangential_damping},        {"L_S", m.largest_cm / 100}, {"gravity", m.gravity},      {"N_E", choice_number(m.elements)},
      {"rotation", choice_number(m.rotation)}};
  std::vector<double> out;
  for (const Axis& axis : space.axes) {
    const auto known = stated.find(axis.name);
    if (known != stated.end() && known->second.standard_error == 0) continue;
    const double value = si.at(axis.name);
    const auto n = static_cast<double>(axis.choices.size());
    const auto which = static_cast<double>(std::ranges::find(axis.choices, value) - axis.choices.begin());
    out.push_back(std::clamp(axis.is_choice() ? (which + 0.5) / n : (value - axis.low) / (axis.high - axis.low), 0.0, 1 - 1e-9));
  }
  out.push_back(0.5);  // of what codes differ by
  return Eigen::Map<const VectorXd>(out.data(), static_cast<Index>(out.size()));
}

StrengthRange exactly(double strength) { return {.low = strength, .high = strength, .below = 0, .above = 0, .logarithmic = true}; }

/// The group whose features a shift moves most, in standard deviations that calibration leaves.
std::string most_moved(const Comparison& comparison, const VectorXd& shift, const MatrixXd& covariance) {
  std::map<Group, std::vector<Index>> groups;
  for (std::size_t k = 0; k < comparison.measured.size(); ++k) groups[comparison.measured[k].group].push_back(static_cast<Index>(k));
  double most = -1;
  std::string out;
  for (const auto& [group, members] : groups) {
    const VectorXd own = shift(members);
    const double distance2 = own.dot(Eigen::LLT<MatrixXd>(covariance(members, members)).solve(own));
    if (distance2 > most) most = distance2, out = group.text();
  }
  return out;
}

/// All effects of a truth, with their strengths; nothing where the emulator lacks one.
std::optional<Hypothesis> hypothesis_of(const Emulator& emulator, const Truth& truth) {
  Hypothesis all{.name = "", .causes = {}};
  for (const auto& [name, strength] : truth.effects) {
    const auto cause = std::ranges::find(emulator.causes(), find_effect(name), &Cause::effect);
    if (cause == emulator.causes().end()) return std::nullopt;
    all.causes.push_back(static_cast<std::size_t>(cause - emulator.causes().begin()));
    all.strength.push_back(exactly(strength));
  }
  return all.causes.empty() ? std::nullopt : std::optional(std::move(all));
}

/// What calibration leaves of shifts, at the true material.
class Leftover {
 public:
  /// Emulator and comparison must outlive it.
  Leftover(const Emulator& emulator, const Comparison& comparison, const ObservationSet& set, const Truth& truth)
      : emulator_(emulator), comparison_(comparison), stated_(stated_in(set, emulator.space())),
        base_(emulator, comparison, {.name = "none", .causes = {}}, stated_), at_(place_of(truth.material, emulator.space(), stated_)),
        tangent_(base_, comparison, at_) {}

  /// [q] whitened
  VectorXd of(const Hypothesis& with) const {
    VectorXd u(at_.size() + static_cast<Index>(with.causes.size()));
    u << at_, VectorXd::Constant(static_cast<Index>(with.causes.size()), 0.5);
    return tangent_.left(tangent_.whitened(Likelihood(emulator_, comparison_, with, stated_).predict(u).mean - tangent_.mean()));
  }

  /// Of each effect alone, the least.
  double weakest(const Hypothesis& all) const {
    double out = INFINITY;
    for (std::size_t k = 0; k < all.causes.size(); ++k) out = std::min(out, of({.name = "", .causes = {all.causes[k]}, .strength = {all.strength[k]}}).norm());
    return out;
  }

  MatrixXd covariance() const { return base_.covariance(base_.predict(at_), at_, 0); }

 private:
  const Emulator& emulator_;
  const Comparison& comparison_;
  const std::map<std::string, Stated> stated_;
  const Likelihood base_;
  const VectorXd at_;
  const Tangent tangent_;
};

}  // namespace

std::optional<TrueGap> true_gap(const Emulator& emulator, const ObservationSet& set, const Truth& truth) {
  const Comparison comparison = compare(emulator, set);
  const auto all = hypothesis_of(emulator, truth);
  if (!all || comparison.size() == 0) return std::nullopt;
  const Leftover leftover(emulator, comparison, set, truth);
  const MatrixXd covariance = leftover.covariance(), lower = Eigen::LLT<MatrixXd>(covariance).matrixL();
  return TrueGap{.isolability = leftover.weakest(*all), .moved = most_moved(comparison, lower * leftover.of(*all), covariance)};
}

std::optional<double> expected_isolability(const Emulator& emulator, const Truth& truth) {
  const auto all = hypothesis_of(emulator, truth);
  if (!all) return std::nullopt;
  const ObservationSet set = observation_of(truth, {});
  const int specimens = static_cast<int>(truth.seeds.size());
  std::vector<Feature> features;
  for (std::size_t j = 0; j < emulator.features().size(); ++j) {
    const FeatureInfo& info = emulator.features()[j];
    const double error = std::sqrt(emulator.noise()[static_cast<Index>(j)] * size_ratio_of(set) / specimens);
    if (info.group.test != Test::kPenetration) features.push_back({.id = info.id, .group = info.group, .standard_error = error, .repeats = specimens});
  }
  Comparison comparison = compare(emulator, features, size_ratio_of(set));
  comparison.differ_by_nothing();
  return Leftover(emulator, comparison, set, truth).weakest(*all);
}

}  // namespace regolab::gap
