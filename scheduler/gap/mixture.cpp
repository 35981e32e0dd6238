#include "scheduler/gap/mixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scheduler/random/philox.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::uint64_t kStream = 0x200000000ULL;
constexpr int kLeastDraws = 32;  // of each density

double log_sum_exp(const VectorXd& v) {
  const double top = v.maxCoeff();
  return std::isfinite(top) ? top + std::log((v.array() - top).exp().sum()) : top;
}

}  // namespace

void Mixture::add(double weight, const VectorXd& mean, const MatrixXd& covariance) {
  components_.push_back({weight, mean, covariance, Eigen::LLT<MatrixXd>(covariance).matrixL()});
}

void Mixture::smooth() {
  double sum = 0;
  VectorXd centre = VectorXd::Zero(size_);
  for (const Component& c : components_) sum += c.weight, centre += c.weight * c.mean;
  centre /= sum;
  MatrixXd scatter = MatrixXd::Zero(size_, size_);
  for (const Component& c : components_) scatter += c.weight / sum * (c.mean - centre) * (c.mean - centre).transpose();
  const double n = static_cast<double>(components_.size()), d = static_cast<double>(size_);
  const double share = std::min(1.0, std::pow(4 / (n * (d + 2)), 1 / (d + 4)));
  for (Component& c : components_) {
    c.mean = centre + std::sqrt(1 - share * share) * (c.mean - centre);
    c.covariance += share * share * scatter;
    c.lower = Eigen::LLT<MatrixXd>(c.covariance).matrixL();
  }
}

VectorXd Mixture::log_density(const MatrixXd& points) const {
  double sum = 0;
  for (const Component& c : components_) sum += c.weight;
  MatrixXd each(static_cast<Index>(components_.size()), points.cols());
  for (std::size_t k = 0; k < components_.size(); ++k) {
    const Component& c = components_[k];
    const MatrixXd z = c.lower.triangularView<Eigen::Lower>().solve(points.colwise() - c.mean);
    const double log_scale = std::log(c.weight / sum) - c.lower.diagonal().array().log().sum() - 0.5 * static_cast<double>(size_) * std::log(2 * std::numbers::pi);
    each.row(static_cast<Index>(k)) = (log_scale - 0.5 * z.colwise().squaredNorm().array()).matrix();
  }
  VectorXd out(points.cols());
  for (Index i = 0; i < points.cols(); ++i) out[i] = log_sum_exp(each.col(i));
  return out;
}

MatrixXd Mixture::draws(Index n, std::uint64_t seed, std::uint64_t stream) const {
  const Philox random(seed, kStream + stream);
  double sum = 0;
  for (const Component& c : components_) sum += c.weight;
  MatrixXd out(size_, n);
  for (Index i = 0; i < n; ++i) {
    const auto point = static_cast<std::uint64_t>(i);
    double left = sum * (static_cast<double>(i) + random.uniform(point, 0, 1)) / static_cast<double>(n);  // stratified over the components
    std::size_t which = 0;
    while (which + 1 < components_.size() && left >= components_[which].weight) left -= components_[which++].weight;
    VectorXd z(size_);
    for (Index k = 0; k < size_; ++k) z[k] = random.normal(point, static_cast<std::uint64_t>(k));
    out.col(i) = components_[which].mean + components_[which].lower * z;
  }
  return out;
}

namespace {

/// log f_i at the draws from f_k: [n_densities] of [n_densities][n_draws].
using Grid = std::vector<MatrixXd>;

Grid grid_of(std::span<const Mixture> densities, std::span<const double> probability, int draws, std::uint64_t seed) {
  Grid out;
  for (std::size_t k = 0; k < densities.size(); ++k) {
    const int n = std::max(kLeastDraws, static_cast<int>(std::lround(probability[k] * draws)));
    const MatrixXd y = densities[k].draws(n, seed, k);
    MatrixXd log_f(static_cast<Index>(densities.size()), n);
    for (std::size_t i = 0; i < densities.size(); ++i) log_f.row(static_cast<Index>(i)) = densities[i].log_density(y).transpose();
    out.push_back(std::move(log_f));
  }
  return out;
}

/// Expected log of f_k over the mixture of all, for draws from f_k: mean, and its squared standard error.
std::pair<double, double> told_by(const MatrixXd& log_f, Index k, const VectorXd& log_probability) {
  VectorXd each(log_f.cols());
  for (Index i = 0; i < log_f.cols(); ++i) each[i] = log_f(k, i) - log_sum_exp(log_f.col(i) + log_probability);
  const double n = static_cast<double>(each.size()), mean = each.mean();
  return {mean, (each.array() - mean).square().sum() / (n * (n - 1))};
}

/// Share of the entropy of "a or b" that y is expected to take away.
double apart(const Grid& grid, Index a, Index b, std::span<const double> probability) {
  const double p = probability[static_cast<std::size_t>(a)], q = probability[static_cast<std::size_t>(b)], sum = p + q;
  const VectorXd two = (VectorXd(2) << std::log(p / sum), std::log(q / sum)).finished();
  const auto half = [&](Index from, Index row) { return told_by(grid[static_cast<std::size_t>(from)](std::vector<Index>{a, b}, Eigen::all), row, two).first; };
  const double told = (p * half(a, 0) + q * half(b, 1)) / sum, all = -(p * two[0] + q * two[1]) / sum;
  return std::clamp(told / all, 0.0, 1.0);
}

}  // namespace

Information information(std::span<const Mixture> densities, std::span<const double> probability, int draws, std::uint64_t seed) {
  const auto n = static_cast<Index>(densities.size());
  const Grid grid = grid_of(densities, probability, draws, seed);
  const VectorXd log_probability = Eigen::Map<const VectorXd>(probability.data(), n).array().log();
  Information out{.apart = MatrixXd::Zero(n, n)};
  double squares = 0;
  for (Index k = 0; k < n; ++k) {
    const double p = probability[static_cast<std::size_t>(k)];
    const auto [mean, error2] = told_by(grid[static_cast<std::size_t>(k)], k, log_probability);
    out.nats += p * mean, squares += p * p * error2;
    for (Index i = 0; i < k; ++i) out.apart(k, i) = out.apart(i, k) = apart(grid, i, k, probability);
  }
  out.nats = std::max(0.0, out.nats), out.error = std::sqrt(squares);
  return out;
}

}  // namespace regolab::gap
