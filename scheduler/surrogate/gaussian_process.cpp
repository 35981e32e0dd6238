#include "scheduler/surrogate/gaussian_process.h"

#include <cmath>
#include <limits>
#include <map>
#include <nlopt.hpp>
#include <utility>

namespace regolab::surrogate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoot5 = 2.23606797749978969;
constexpr double kJitter = 1e-8;  // of the output's variance: keeps the factorisation going where points coincide
// Priors, in logarithms: mean and standard deviation.
constexpr double kLengthMean = 0.7, kLengthSpread = 1.3, kSignalSpread = 2, kTrendMean = -2, kTrendSpread = 2, kNoiseMean = -4, kNoiseSpread = 2;

struct Standardised {
  double centre, scale;
  VectorXd y;
};

Standardised standardise(const VectorXd& y) {
  const double centre = y.mean();
  const double scale = std::sqrt((y.array() - centre).square().sum() / static_cast<double>(std::max<Index>(1, y.size() - 1)));
  return {centre, scale, (y.array() - centre) / scale};
}

double matern(double r) { return (1 + kRoot5 * r + 5.0 / 3.0 * r * r) * std::exp(-kRoot5 * r); }

VectorXd inverse_lengths(const std::vector<double>& log_length) {
  VectorXd out(static_cast<Index>(log_length.size()));
  for (Index j = 0; j < out.size(); ++j) out[j] = std::exp(-log_length[static_cast<std::size_t>(j)]);
  return out;
}

/// Points as columns, so that a pair is two stretches of memory: in units of the lengths, and from the middle of the box.
struct Columns {
  MatrixXd scaled, centred;  // [n_inputs][n]
};
Columns columns_of(const MatrixXd& x, const VectorXd& inverse_length) {
  return {(x * inverse_length.asDiagonal()).transpose(), (x.array() - 0.5).matrix().transpose()};
}
double trend(const Columns& c, Index i, Index j) { return 1 + 4 * c.centred.col(i).dot(c.centred.col(j)); }

/// Distances between all points, by one product: what cancels there is far below what the smooth kernel feels.
MatrixXd distances(const MatrixXd& scaled) {
  const VectorXd square = scaled.colwise().squaredNorm().transpose();
  MatrixXd r2 = -2.0 * (scaled.transpose() * scaled);
  r2.colwise() += square;
  r2.rowwise() += square.transpose();
  return r2.cwiseMax(0.0).cwiseSqrt();
}

MatrixXd covariance(const Observations& data, const Hyperparameters& h) {
  const Columns at = columns_of(data.x, inverse_lengths(h.log_length));
  const double signal = std::exp(h.log_signal), slope = std::exp(h.log_trend), noise = std::exp(h.log_noise);
  const Eigen::ArrayXXd r = distances(at.scaled).array();
  MatrixXd k = signal * (1 + kRoot5 * r + 5.0 / 3.0 * r.square()) * (-kRoot5 * r).exp();
  k.array() += slope * (1 + 4 * (at.centred.transpose() * at.centred).array());
  k.diagonal().array() += noise / data.runs.array() + kJitter;
  return k;
}

Hyperparameters unpack(const std::vector<double>& p) {
  const std::size_t d = p.size() - 3;
  return {.log_length = {p.begin(), p.begin() + static_cast<std::ptrdiff_t>(d)}, .log_signal = p[d], .log_trend = p[d + 1], .log_noise = p[d + 2]};
}

std::pair<double, double> prior_of(std::size_t i, std::size_t d) {
  if (i < d) return {kLengthMean, kLengthSpread};
  if (i == d) return {0, kSignalSpread};
  return i == d + 1 ? std::pair(kTrendMean, kTrendSpread) : std::pair(kNoiseMean, kNoiseSpread);
}

/// 0.5 tr((a a^T - K^-1) dK/dp) for every parameter, in one pass over the pairs.
void add_likelihood_gradient(const Observations& data, const Hyperparameters& h, const MatrixXd& inverse_k, const VectorXd& a,
                             std::vector<double>& gradient) {
  const Index n = data.x.rows(), d = data.x.cols();
  const Columns at = columns_of(data.x, inverse_lengths(h.log_length));
  const double signal = std::exp(h.log_signal), slope = std::exp(h.log_trend), noise = std::exp(h.log_noise);
  VectorXd by_length = VectorXd::Zero(d), gap(d);
  double by_signal = 0, by_trend = 0, by_noise = 0;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j <= i; ++j) {
      const double weight = (i == j ? 0.5 : 1.0) * (a[i] * a[j] - inverse_k(i, j));
      gap = at.scaled.col(i) - at.scaled.col(j);
      const double r = gap.norm(), decay = std::exp(-kRoot5 * r);
      by_signal += weight * signal * (1 + kRoot5 * r + 5.0 / 3.0 * r * r) * decay;
      by_trend += weight * slope * trend(at, i, j);
      by_length.array() += (weight * signal * 5.0 / 3.0 * (1 + kRoot5 * r) * decay) * gap.array().square();
    }
    by_noise += 0.5 * (a[i] * a[i] - inverse_k(i, i)) * noise / data.runs[i];
  }
  for (Index j = 0; j < d; ++j) gradient[static_cast<std::size_t>(j)] += by_length[j];
  gradient[static_cast<std::size_t>(d)] += by_signal;
  gradient[static_cast<std::size_t>(d) + 1] += by_trend;
  gradient[static_cast<std::size_t>(d) + 2] += by_noise;
}

}  // namespace

double log_posterior(const Observations& data, const std::vector<double>& p, std::vector<double>* gradient) {
  const Hyperparameters h = unpack(p);
  const VectorXd y = standardise(data.y).y;
  const Eigen::LLT<MatrixXd> factor(covariance(data, h));
  if (factor.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  const VectorXd a = factor.solve(y);
  double value = -0.5 * y.dot(a) - factor.matrixLLT().diagonal().array().log().sum();
  const std::size_t d = p.size() - 3;
  if (gradient) {
    gradient->assign(p.size(), 0.0);
    add_likelihood_gradient(data, h, factor.solve(MatrixXd::Identity(y.size(), y.size())), a, *gradient);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto [mean, spread] = prior_of(i, d);
    const double z = (p[i] - mean) / spread;
    value -= 0.5 * z * z;
    if (gradient) (*gradient)[i] -= z / spread;
  }
  return value;
}

Hyperparameters fit_hyperparameters(const Observations& data) {
  const auto d = static_cast<std::size_t>(data.x.cols());
  std::vector<double> best;
  double highest = -std::numeric_limits<double>::infinity();
  for (const double start : {0.0, 1.0}) {  // of all lengths: wiggly, smooth
    nlopt::opt optimiser(nlopt::LD_LBFGS, static_cast<unsigned>(d + 3));
    auto objective = [](const std::vector<double>& p, std::vector<double>& gradient, void* observations) {
      return log_posterior(*static_cast<const Observations*>(observations), p, gradient.empty() ? nullptr : &gradient);
    };
    optimiser.set_max_objective(+objective, const_cast<Observations*>(&data));
    optimiser.set_lower_bounds(-4);
    std::vector<double> upper(d + 3, 5);
    upper[d + 2] = 1;
    optimiser.set_upper_bounds(upper);
    std::vector<double> lower(d + 3, -3);
    lower[d + 1] = lower[d + 2] = -10;
    optimiser.set_lower_bounds(lower);
    optimiser.set_ftol_abs(1e-4);
    optimiser.set_maxeval(150);
    std::vector<double> p(d + 3, start);
    p[d] = 0, p[d + 1] = -2, p[d + 2] = -3;
    double value = 0;
    try {
      optimiser.optimize(p, value);
    } catch (const std::runtime_error&) {  // stopped by round-off near the top: where it stands is an answer
      value = log_posterior(data, p, nullptr);
    }
    if (value > highest) highest = value, best = p;
  }
  return unpack(best);
}

GaussianProcess::GaussianProcess(Observations observations, Hyperparameters hyperparameters)
    : data_(std::move(observations)), hyper_(std::move(hyperparameters)) {
  const Standardised s = standardise(data_.y);
  centre_ = s.centre, scale_ = s.scale;
  Columns at = columns_of(data_.x, inverse_lengths(hyper_.log_length));
  scaled_ = std::move(at.scaled), centred_ = std::move(at.centred);
  const Eigen::LLT<MatrixXd> factor(covariance(data_, hyper_));
  lower_ = factor.matrixL();
  weights_ = factor.solve(s.y);
}

GaussianProcess::Prediction GaussianProcess::predict(const VectorXd& x) const {
  const Index n = data_.x.rows();
  const VectorXd scaled = x.array() * inverse_lengths(hyper_.log_length).array(), centred = x.array() - 0.5;
  const double signal = std::exp(hyper_.log_signal), slope = std::exp(hyper_.log_trend);
  VectorXd k(n);
  for (Index i = 0; i < n; ++i) {
    k[i] = signal * matern((scaled_.col(i) - scaled).norm()) + slope * (1 + 4 * centred_.col(i).dot(centred));
  }
  const VectorXd v = lower_.triangularView<Eigen::Lower>().solve(k);
  const double variance = std::max(0.0, signal + slope * (1 + 4 * centred.squaredNorm()) - v.squaredNorm());
  return {centre_ + scale_ * k.dot(weights_), scale_ * scale_ * variance, scale_ * scale_ * std::exp(hyper_.log_noise)};
}

std::vector<GaussianProcess::Prediction> GaussianProcess::leave_groups_out(const std::vector<int>& group) const {
  const Index n = data_.x.rows();
  const MatrixXd half = lower_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(n, n));
  const MatrixXd inverse = half.transpose() * half;  // K^-1
  const double noise = scale_ * scale_ * std::exp(hyper_.log_noise);
  std::map<int, std::vector<Index>> members;
  for (Index i = 0; i < n; ++i) members[group[static_cast<std::size_t>(i)]].push_back(i);
  std::vector<Prediction> out(static_cast<std::size_t>(n));
  for (const auto& [id, rows] : members) {
    // Without block B: mean y_B - (K^-1_BB)^-1 (K^-1 y)_B, covariance (K^-1_BB)^-1.
    const MatrixXd block = inverse(rows, rows).inverse();
    const VectorXd off = block * weights_(rows);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto at = static_cast<Index>(k);
      out[static_cast<std::size_t>(rows[k])] = {data_.y[rows[k]] - scale_ * off[at],
                                                std::max(0.0, scale_ * scale_ * block(at, at) - noise / data_.runs[rows[k]]), noise};
    }
  }
  return out;
}

}  // namespace regolab::surrogate
