#include "scheduler/gap/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scheduler/gap/between_codes.h"
#include "scheduler/gap/strength_line.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBankParticles = 300;

double log_student(double distance2, double log_det, Index q) {
  const auto n = static_cast<double>(q);
  return std::lgamma(0.5 * (kFreedom + n)) - std::lgamma(0.5 * kFreedom) - 0.5 * n * std::log(kFreedom * std::numbers::pi) - 0.5 * log_det -
         0.5 * (kFreedom + n) * std::log1p(distance2 / kFreedom);
}

/// Variance of the measured mean of one feature, and how much of it our own runs say.
struct Variance {
  double all, ours;
};
Variance variance_of(const Feature& f, double own_noise, double size_ratio) {
  const double n = std::max(1, f.repeats), expected = own_noise * size_ratio / n, given = f.standard_error * f.standard_error;
  const double own_freedom = f.assumed ? 0 : n - 1;
  if (n <= 1 && !f.assumed) return {std::max(given, expected), given > expected ? 0 : expected};
  const double pooled = (kPriorFreedom * expected + own_freedom * given) / (kPriorFreedom + own_freedom), ours = kPriorFreedom * expected / (kPriorFreedom + own_freedom);
  return f.assumed && given > pooled ? Variance{given, 0} : Variance{pooled, ours};
}

/// Confining stresses of the emulator's sigma1, ascending [Pa].
std::vector<double> sigma3_of(const Emulator& emulator) {
  std::vector<double> out;
  for (const FeatureInfo& f : emulator.features()) {
    if (f.id.starts_with("sigma1_ratio_")) out.push_back(f.group.sigma3);
  }
  std::ranges::sort(out);
  return out;
}

/// Beds of grains of another density pack alike: the same share of the volume is grains.
void weigh_as_in_bank(const Emulator& emulator, const ObservationSet& set, std::vector<Feature>& features) {
  const auto own = emulator.space().fixed.find("particle_density");
  if (own == emulator.space().fixed.end() || !set.material.grain_density) return;
  const Known& grain = *set.material.grain_density;
  for (Feature& f : features) {
    if (f.id != "bulk_density" && f.id != "core_density") continue;
    const double unsure = f.value * grain.standard_error.value_or(0) / grain.value;
    f.standard_error = std::hypot(f.standard_error, unsure) * own->second / grain.value;
    f.value *= own->second / grain.value;
  }
}

/// Both ends of a strength line err by the same two numbers, and by nothing that other features share.
void go_together(const StrengthLine& line, Comparison& comparison) {
  std::array<Index, 2> at;
  for (std::size_t k = 0; k < 2; ++k) {
    at[k] = std::ranges::find(comparison.measured, line.ends[k].id, &Feature::id) - comparison.measured.begin();
    comparison.correlation.row(at[k]).setZero(), comparison.correlation.col(at[k]).setZero();
    comparison.correlation(at[k], at[k]) = 1;
  }
  const double own = line.correlation * line.ends[0].standard_error * line.ends[1].standard_error;
  comparison.correlation(at[0], at[1]) = comparison.correlation(at[1], at[0]) = own / std::sqrt(comparison.variance[at[0]] * comparison.variance[at[1]]);
}

void as_of_usual_size(const Predicted& shift, Comparison& comparison) {
  if (shift.mean.size() == 0) return;
  for (Index k = 0; k < comparison.size(); ++k) {
    const Index of = comparison.feature[static_cast<std::size_t>(k)];
    comparison.size_shift[k] = shift.mean(of, 0), comparison.size_variance[k] = shift.variance(of, 0);
  }
  comparison.y -= comparison.size_shift;
}

}  // namespace

double size_ratio_of(const ObservationSet& set) { return std::min(1.0, kBankParticles / set.specimen.particles.value_or(kBankParticles)); }

Comparison compare(const Emulator& emulator, const ObservationSet& set) {
  auto features = features_of(readings_of(set));
  weigh_as_in_bank(emulator, set, features);
  const auto line = strength_line(features, sigma3_of(emulator), set.protocol.sigma3);
  if (line) features.insert(features.end(), line->ends.begin(), line->ends.end());
  Comparison out = compare(emulator, features, size_ratio_of(set));
  if (line) go_together(*line, out);
  if (set.specimen.particles) as_of_usual_size(emulator.of_particles(*set.specimen.particles), out);
  out.same_code = set.source == kSameCode;
  return out;
}

Comparison compare(const Emulator& emulator, const std::vector<Feature>& features, double size_ratio) {
  Comparison out;
  std::vector<double> y, variance, ours, own, share;
  for (const Feature& f : features) {
    const int at = emulator.feature(f.id);
    if (at < 0) continue;
    out.feature.push_back(at);
    out.measured.push_back(f);
    y.push_back(f.value);
    own.push_back(std::sqrt(emulator.noise()[at]));
    share.push_back(size_ratio / std::max(1, f.repeats));
    const Variance v = variance_of(f, emulator.noise()[at], size_ratio);
    variance.push_back(v.all), ours.push_back(v.ours);
  }
  out.y = Eigen::Map<const VectorXd>(y.data(), static_cast<Index>(y.size()));
  const VectorXd sd = Eigen::Map<const VectorXd>(own.data(), out.size());
  out.ours = Eigen::Map<const VectorXd>(ours.data(), out.size());
  out.share = Eigen::Map<const VectorXd>(share.data(), out.size());
  out.between_alone = kAlone * kAlone * sd.cwiseAbs2();
  out.variance = Eigen::Map<const VectorXd>(variance.data(), static_cast<Index>(variance.size())) + out.between_alone + sd.cwiseProduct(by_records(out.measured)).cwiseAbs2();
  out.by_step = sd.cwiseProduct(by_step(out.measured));
  out.size_shift = out.size_variance = VectorXd::Zero(out.size());
  out.correlation = emulator.correlation()(out.feature, out.feature);
  out.error_correlation = emulator.error_correlation()(out.feature, out.feature);
  const MatrixXd together = sd.asDiagonal() * between_codes(out.measured);
  out.between_codes = together * together.transpose();
  return out;
}

MatrixXd Comparison::base_error(const VectorXd& emulator_variance) const {
  const VectorXd wrong = (emulator_variance + size_variance).cwiseSqrt();
  MatrixXd out = wrong.asDiagonal() * error_correlation * wrong.asDiagonal();
  out += by_step * by_step.transpose();
  return out;
}

MatrixXd Comparison::covariance(const MatrixXd& error, double difference, const VectorXd& scale) const {
  const double size = difference * difference;
  VectorXd own = variance + (size - 1) * between_alone;
  if (scale.size() > 0) own += (scale.array() - 1).matrix().cwiseProduct(ours);
  const VectorXd sd = own.cwiseSqrt();
  MatrixXd out = error + size * between_codes;
  out += sd.asDiagonal() * correlation * sd.asDiagonal();
  return out;
}

void Comparison::differ_by_nothing() {
  variance -= between_alone;
  between_alone.setZero(), between_codes.setZero();
}

Comparison Comparison::subset(const std::vector<Index>& kept) const {
  Comparison out;
  out.same_code = same_code;
  for (const Index k : kept) out.feature.push_back(feature[static_cast<std::size_t>(k)]), out.measured.push_back(measured[static_cast<std::size_t>(k)]);
  out.y = y(kept), out.variance = variance(kept), out.share = share(kept), out.ours = ours(kept), out.between_alone = between_alone(kept), out.by_step = by_step(kept), out.size_variance = size_variance(kept), out.size_shift = size_shift(kept);
  out.correlation = correlation(kept, kept);
  out.error_correlation = error_correlation(kept, kept);
  out.between_codes = between_codes(kept, kept);
  return out;
}

double student_t_log_density(const VectorXd& off, const MatrixXd& covariance) {
  const Eigen::LLT<MatrixXd> factor(covariance);
  const double log_det = 2 * factor.matrixLLT().diagonal().array().log().sum();
  return log_student(off.dot(factor.solve(off)), log_det, off.size());
}

}  // namespace regolab::gap
