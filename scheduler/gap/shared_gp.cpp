#include "scheduler/gap/shared_gp.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>
#include <utility>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoot5 = 2.23606797749978969;
constexpr double kJitter = 1e-8;
// Priors, in logarithms: mean and standard deviation. An input that does nothing gets a long length instead of a fit.
constexpr double kLengthMean = 0.7, kLengthSpread = 1.3, kTrendMean = -2, kTrendSpread = 2, kNoiseMean = -3, kNoiseSpread = 3;
constexpr double kLeastNoise = -9, kMostNoise = 4;

VectorXd inverse_lengths(const Kernel& kernel) {
  VectorXd out(static_cast<Index>(kernel.group.size()));
  for (Index j = 0; j < out.size(); ++j) out[j] = std::exp(-kernel.log_length[static_cast<std::size_t>(kernel.group[static_cast<std::size_t>(j)])]);
  return out;
}

/// [n][m] between the rows of a and of b.
MatrixXd covariance(const Kernel& kernel, const MatrixXd& a, const MatrixXd& b) {
  const VectorXd inverse = inverse_lengths(kernel);
  const MatrixXd sa = a * inverse.asDiagonal(), sb = b * inverse.asDiagonal();
  MatrixXd r2 = -2.0 * (sa * sb.transpose());
  r2.colwise() += sa.rowwise().squaredNorm();
  r2.rowwise() += sb.rowwise().squaredNorm().transpose();
  const Eigen::ArrayXXd r = r2.array().max(0.0).sqrt();
  const MatrixXd trend = (a.array() - 0.5).matrix() * (b.array() - 0.5).matrix().transpose();
  return (1 + std::exp(kernel.log_trend) * (1 + 4 * trend.array()) + (1 + kRoot5 * r + 5.0 / 3.0 * r.square()) * (-kRoot5 * r).exp()).matrix();
}

/// Prior variance at each row of x.
VectorXd prior_variance(const Kernel& kernel, const MatrixXd& x) {
  return (2 + std::exp(kernel.log_trend) * (1 + 4 * (x.array() - 0.5).square().rowwise().sum())).matrix();
}

struct Spectrum {
  MatrixXd vectors;
  VectorXd values;
};
Spectrum spectrum_of(const Kernel& kernel, const Sample& s) {
  const VectorXd root = s.weight.cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(root.asDiagonal() * covariance(kernel, s.x, s.x) * root.asDiagonal());
  return {solved.eigenvectors(), solved.eigenvalues().cwiseMax(0.0).array() + kJitter};
}

/// y from its weighted mean, in units of its spread.
void standardise(const Sample& s, VectorXd& centre, VectorXd& scale, MatrixXd& y) {
  centre = (s.weight.transpose() * s.y).transpose() / s.weight.sum();
  y = s.y.rowwise() - centre.transpose();
  scale = (y.array().square().colwise().sum() / static_cast<double>(std::max<Index>(1, y.rows() - 1))).sqrt().matrix().transpose();
  scale = (scale.array() > 0).select(scale, 1.0);
  y.array().rowwise() /= scale.transpose().array();
}

/// Log posterior of one output's noise (its amplitude at the best). z2: squares of the output in the eigenbasis.
double noise_posterior(const VectorXd& values, const VectorXd& z2, double log_noise) {
  const auto n = static_cast<double>(values.size());
  const Eigen::ArrayXd width = values.array() + std::exp(log_noise);
  const double off = (log_noise - kNoiseMean) / kNoiseSpread;
  return -0.5 * n * std::log((z2.array() / width).sum() / n) - 0.5 * width.log().sum() - 0.5 * off * off;
}

std::pair<double, double> best_noise(const VectorXd& values, const VectorXd& z2) {
  double best = kLeastNoise, highest = -std::numeric_limits<double>::infinity();
  for (double step = 1; step > 0.01; step /= 4) {  // a coarse grid, refined around its top
    const double low = step == 1 ? kLeastNoise : std::max(kLeastNoise, best - 4 * step), high = step == 1 ? kMostNoise : std::min(kMostNoise, best + 4 * step);
    for (double at = low; at <= high + 1e-12; at += step) {
      const double value = noise_posterior(values, z2, at);
      if (value > highest) highest = value, best = at;
    }
  }
  return {best, highest};
}

struct Fit {
  const Sample& sample;
  Kernel kernel;

  double posterior(const std::vector<double>& p) {
    const std::size_t g = p.size() - 1;
    kernel.log_length.assign(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(g));
    kernel.log_trend = p[g];
    VectorXd centre, scale;
    MatrixXd y;
    standardise(sample, centre, scale, y);
    const Spectrum spectrum = spectrum_of(kernel, sample);
    const MatrixXd z = spectrum.vectors.transpose() * sample.weight.cwiseSqrt().asDiagonal() * y;
    kernel.log_noise.clear();
    double sum = 0;
    for (Index j = 0; j < z.cols(); ++j) {
      const auto [noise, value] = best_noise(spectrum.values, z.col(j).array().square());
      kernel.log_noise.push_back(noise);
      sum += value;
    }
    for (std::size_t i = 0; i < g; ++i) sum -= 0.5 * std::pow((p[i] - kLengthMean) / kLengthSpread, 2);
    return sum - 0.5 * std::pow((p[g] - kTrendMean) / kTrendSpread, 2);
  }
};

}  // namespace

SharedGp::SharedGp(Sample sample, Kernel kernel) : sample_(std::move(sample)), kernel_(std::move(kernel)) {
  MatrixXd y;
  standardise(sample_, centre_, scale_, y);
  const Spectrum spectrum = spectrum_of(kernel_, sample_);
  const VectorXd root = sample_.weight.cwiseSqrt();
  vectors_ = root.asDiagonal() * spectrum.vectors;
  values_ = spectrum.values;
  const MatrixXd z = vectors_.transpose() * y;
  const Index n = y.rows(), p = y.cols();
  amplitude_.resize(p), noise_.resize(p), alpha_.resize(n, p);
  MatrixXd told(n, p);
  for (Index j = 0; j < p; ++j) {
    const double noise = std::exp(kernel_.log_noise[static_cast<std::size_t>(j)]);
    const Eigen::ArrayXd width = values_.array() + noise;
    amplitude_[j] = (z.col(j).array().square() / width).sum() / static_cast<double>(n);
    noise_[j] = amplitude_[j] * noise * scale_[j] * scale_[j];
    alpha_.col(j) = vectors_ * (z.col(j).array() / width).matrix();
    told.col(j) = width.inverse();
  }
  run_ = sample_.x * inverse_lengths(kernel_).asDiagonal();
  slope_ = padded((sample_.x.array() - 0.5).matrix().transpose());
  alpha_rows_ = padded(alpha_), vector_rows_ = padded(vectors_), told_ = padded(told);
}

Predicted SharedGp::predict(const MatrixXd& x) const {
  Predicted out{MatrixXd(alpha_.cols(), x.rows()), MatrixXd(alpha_.cols(), x.rows())};
  for (Index first = 0; first < x.rows(); first += kBlock) predict_block(x, first, out);
  return out;
}

void SharedGp::predict_block(const MatrixXd& all, Index first, Predicted& out) const {
  const Index n = std::min(kBlock, all.rows() - first), p = alpha_.cols();
  const MatrixXd x = all.middleRows(first, n);
  Rows middle = Rows::Zero(x.cols(), kBlock), point = middle, k, mean, direction, told;
  middle.leftCols(n) = (x.array() - 0.5).matrix().transpose();
  point.leftCols(n) = (x * inverse_lengths(kernel_).asDiagonal()).transpose();
  multiply(slope_, middle, k);
  k = (1 + std::exp(kernel_.log_trend) * (1 + 4 * k.array())).matrix();
  add_matern(run_, point, k);
  k.conservativeResize(run_.rows(), kBlock);  // without the padding
  multiply(alpha_rows_, k, mean);
  multiply(vector_rows_, k, direction);
  direction = direction.topRows(run_.rows()).array().square().matrix().eval();
  multiply(told_, direction, told);
  const VectorXd prior = prior_variance(kernel_, x);
  for (Index j = 0; j < p; ++j) {
    out.mean.row(j).segment(first, n) = (mean.row(j).head(n).array() * scale_[j] + centre_[j]).matrix();
    out.variance.row(j).segment(first, n) = ((prior.transpose() - told.row(j).head(n)).cwiseMax(0.0)) * (amplitude_[j] * scale_[j] * scale_[j]);
  }
}

Predicted SharedGp::leave_one_out() const {
  const Index n = sample_.x.rows(), p = alpha_.cols();
  Predicted out{MatrixXd(p, n), MatrixXd(p, n)};
  for (Index j = 0; j < p; ++j) {
    const VectorXd inverse = (values_.array() + std::exp(kernel_.log_noise[static_cast<std::size_t>(j)])).inverse();
    const double unit = amplitude_[j] * scale_[j] * scale_[j];
    for (Index i = 0; i < n; ++i) {
      const double precision = (vectors_.row(i).array().square() * inverse.transpose().array()).sum();  // of K_ii^-1, noise included
      out.mean(j, i) = sample_.y(i, j) - scale_[j] * alpha_(i, j) / precision;
      out.variance(j, i) = std::max(0.0, unit / precision - noise_[j] / sample_.weight[i]);
    }
  }
  return out;
}

Kernel fit_kernel(const Sample& sample, const Groups& group) {
  const auto groups = static_cast<std::size_t>(*std::ranges::max_element(group)) + 1;
  Kernel best;
  double highest = -std::numeric_limits<double>::infinity();
  for (const double start : {0.0, 1.0}) {  // of all lengths: wiggly, smooth
    Fit fit{sample, {.group = group, .log_length = {}, .log_noise = {}}};
    nlopt::opt optimiser(nlopt::LN_BOBYQA, static_cast<unsigned>(groups + 1));
    optimiser.set_max_objective(
        +[](const std::vector<double>& p, std::vector<double>&, void* f) { return static_cast<Fit*>(f)->posterior(p); }, &fit);
    std::vector<double> lower(groups + 1, -2.5), upper(groups + 1, 4.5), p(groups + 1, start);
    lower[groups] = -9, p[groups] = kTrendMean;
    optimiser.set_lower_bounds(lower), optimiser.set_upper_bounds(upper);
    optimiser.set_initial_step(0.7);
    optimiser.set_ftol_abs(0.01);
    optimiser.set_maxeval(40 * static_cast<int>(groups + 1));
    double value = 0;
    try {
      optimiser.optimize(p, value);
    } catch (const std::runtime_error&) {  // stopped by round-off near the top: where it stands is an answer
    }
    value = fit.posterior(p);
    if (value > highest) highest = value, best = fit.kernel;
  }
  return best;
}

}  // namespace regolab::gap
