#include "scheduler/gap/smc.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scheduler/random/philox.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kJump = 0.15;  // share of moves that redraw one parameter from its prior: choices, and far modes

/// A particle in the counter of its draws.
std::uint64_t number_of(Index particle) { return static_cast<std::uint64_t>(particle); }

/// The next power: as far as keeps the share of particles that still count.
double next_power(const VectorXd& log_likelihood, double power, double kept) {
  const auto share = [&](double next) {
    const Eigen::ArrayXd w = ((next - power) * (log_likelihood.array() - log_likelihood.maxCoeff())).exp();
    return w.sum() * w.sum() / (w.square().sum() * static_cast<double>(w.size()));
  };
  if (share(1) >= kept) return 1;
  double low = power, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (share(middle) >= kept ? low : high) = middle;
  }
  return std::max(low, power + 1e-12);
}

/// Systematic resampling: index of the ancestor of each particle.
std::vector<Index> ancestors(const Eigen::ArrayXd& weight, double offset) {
  std::vector<Index> out;
  const double n = static_cast<double>(weight.size()), sum = weight.sum();
  double below = 0;
  for (Index i = 0; i < weight.size(); ++i) {
    below += weight[i] / sum * n;
    while (static_cast<double>(out.size()) + offset < below && out.size() < static_cast<std::size_t>(weight.size())) out.push_back(i);
  }
  while (out.size() < static_cast<std::size_t>(weight.size())) out.push_back(weight.size() - 1);
  return out;
}

double reflected(double u) {
  u = std::abs(std::fmod(u, 2.0));
  return u > 1 ? 2 - u : u;
}

class Walkers {
 public:
  Walkers(const LogLikelihood& f, int parameters, int particles, const Philox& draws) : f_(f), draws_(draws), u(parameters, particles) {
    for (Index i = 0; i < u.cols(); ++i) {
      for (Index d = 0; d < u.rows(); ++d) u(d, i) = draws_.uniform(0, number_of(i), static_cast<std::uint64_t>(d));
    }
    log_likelihood = f_(u);
  }

  void resample(const Eigen::ArrayXd& weight, std::uint64_t stage) {
    const auto from = ancestors(weight, draws_.uniform(stage, ~std::uint64_t{0}, 0));
    u = MatrixXd(u(Eigen::all, from));
    log_likelihood = VectorXd(log_likelihood(from));
  }

  /// Random-walk Metropolis steps, shaped by the spread of the particles.
  void move(double power, std::uint64_t stage) {
    const MatrixXd centred = u.colwise() - u.rowwise().mean();
    MatrixXd spread = centred * centred.transpose() / static_cast<double>(u.cols());
    spread.diagonal().array() += 1e-8;
    const MatrixXd root = Eigen::LLT<MatrixXd>(spread).matrixL();
    const auto d = static_cast<std::uint64_t>(u.rows());
    MatrixXd proposed(u.rows(), u.cols());
    for (Index i = 0; i < u.cols(); ++i) {
      if (draws_.uniform(stage, number_of(i), 2 * d) < kJump) {
        proposed.col(i) = u.col(i);
        const auto which = std::min<Index>(u.rows() - 1, static_cast<Index>(draws_.uniform(stage, number_of(i), 2 * d + 1) * static_cast<double>(u.rows())));
        proposed(which, i) = draws_.uniform(stage, number_of(i), 2 * d + 2);
        continue;
      }
      VectorXd z(u.rows());
      for (Index k = 0; k < z.size(); ++k) z[k] = draws_.normal(stage, number_of(i), static_cast<std::uint64_t>(k));
      proposed.col(i) = (u.col(i) + scale_ * (root * z)).unaryExpr(&reflected);
    }
    const VectorXd there = f_(proposed);
    int taken = 0;
    for (Index i = 0; i < u.cols(); ++i) {
      if (std::log(draws_.uniform(stage, number_of(i), 2 * d + 3)) >= power * (there[i] - log_likelihood[i])) continue;
      u.col(i) = proposed.col(i);
      log_likelihood[i] = there[i];
      ++taken;
    }
    const double share = static_cast<double>(taken) / static_cast<double>(u.cols());
    scale_ = std::clamp(scale_ * std::exp(share - 0.25), 0.05, 2.0);
  }

 private:
  const LogLikelihood& f_;
  Philox draws_;
  double scale_ = 0.7;

 public:
  MatrixXd u;
  VectorXd log_likelihood;
};

struct Run {
  double log_z;
  MatrixXd u;
  VectorXd log_likelihood;
};

Run run_once(const LogLikelihood& f, int parameters, const SmcOptions& o, int repeat) {
  Walkers walkers(f, parameters, o.particles, Philox(o.seed, static_cast<std::uint64_t>(repeat)));
  double power = 0, log_z = 0;
  for (std::uint64_t stage = 1; power < 1; stage += 100) {
    const double next = next_power(walkers.log_likelihood, power, o.kept);
    const VectorXd log_weight = (next - power) * walkers.log_likelihood;
    log_z += log_mean_exp(log_weight);
    walkers.resample((log_weight.array() - log_weight.maxCoeff()).exp(), stage);
    power = next;
    for (int m = 1; m <= o.moves; ++m) walkers.move(power, stage + static_cast<std::uint64_t>(m));
  }
  return {log_z, std::move(walkers.u), std::move(walkers.log_likelihood)};
}

}  // namespace

double log_mean_exp(const VectorXd& v) {
  const double top = v.maxCoeff();
  return top + std::log((v.array() - top).exp().mean());
}

Posterior sample_posterior(const LogLikelihood& f, int parameters, const SmcOptions& o) {
  Posterior out;
  VectorXd log_z(o.repeats);
  out.u.resize(parameters, static_cast<Index>(o.repeats) * o.particles);
  out.log_likelihood.resize(out.u.cols());
  for (int r = 0; r < o.repeats; ++r) {
    const Run run = run_once(f, parameters, o, r);
    log_z[r] = run.log_z;
    out.u.middleCols(static_cast<Index>(r) * o.particles, o.particles) = run.u;
    out.log_likelihood.segment(static_cast<Index>(r) * o.particles, o.particles) = run.log_likelihood;
  }
  out.log_z = log_mean_exp(log_z);
  const double n = o.repeats;
  out.log_z_error = o.repeats < 2 ? 0 : std::sqrt((log_z.array() - log_z.mean()).square().sum() / (n - 1) / n);
  return out;
}

Posterior together(const Posterior& one, const Posterior& other) {
  Posterior out;
  out.log_z = log_mean_exp(Eigen::Vector2d(one.log_z, other.log_z));
  out.log_z_error = 0.5 * std::abs(one.log_z - other.log_z);
  out.u.resize(one.u.rows(), one.u.cols() + other.u.cols());
  out.u << one.u, other.u;
  out.log_likelihood.resize(one.log_likelihood.size() + other.log_likelihood.size());
  out.log_likelihood << one.log_likelihood, other.log_likelihood;
  return out;
}

}  // namespace regolab::gap
