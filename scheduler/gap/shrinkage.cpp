#include "scheduler/gap/shrinkage.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scheduler/gap/draws.h"
#include "scheduler/gap/quantile.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kResamples = 2000;
constexpr int kErrorStream = 7001, kNullErrorStream = 27001;  // a stream for each resample
constexpr std::uint64_t kBaseStream = 7, kRepairedStream = 8, kNullStream = 9;

/// Mean, variance and number of the runs that have a number, feature by feature.
struct Summary {
  VectorXd mean, variance, n;  // [q]
};

Summary summary_of(const MatrixXd& runs) {
  Summary out{VectorXd::Zero(runs.rows()), VectorXd::Zero(runs.rows()), VectorXd::Zero(runs.rows())};
  for (Index f = 0; f < runs.rows(); ++f) {
    double n = 0, sum = 0, squares = 0;
    for (Index r = 0; r < runs.cols(); ++r) {
      if (std::isfinite(runs(f, r))) ++n, sum += runs(f, r);
    }
    const double mean = n > 0 ? sum / n : NAN;
    for (Index r = 0; r < runs.cols(); ++r) {
      if (std::isfinite(runs(f, r))) squares += (runs(f, r) - mean) * (runs(f, r) - mean);
    }
    out.mean[f] = mean, out.n[f] = n, out.variance[f] = n > 1 ? squares / (n - 1) : NAN;
  }
  return out;
}

/// Mean over the features that enough runs have. `noise`: expected squared distance without a gap, by feature.
double mean_square(const VectorXd& off, const VectorXd& noise, const VectorXd& variance, const VectorXd& n) {
  double sum = 0;
  int used = 0;
  for (Index f = 0; f < off.size(); ++f) {
    if (n[f] < kFewestRuns) continue;
    sum += (off[f] * off[f] - noise[f]) / variance[f];
    ++used;
  }
  return used == 0 ? NAN : sum / used;
}

/// Run means with the runs drawn anew.
VectorXd resampled_mean(const MatrixXd& runs, const VectorXd& otherwise, std::uint64_t seed, std::uint64_t stream, int resample) {
  const auto n = static_cast<double>(runs.cols());
  VectorXd sum = VectorXd::Zero(runs.rows()), count = VectorXd::Zero(runs.rows());
  for (Index k = 0; k < runs.cols(); ++k) {
    const auto r = std::min<Index>(runs.cols() - 1, static_cast<Index>(n * uniform(seed, stream, static_cast<std::uint64_t>(resample), static_cast<std::uint64_t>(k))));
    for (Index f = 0; f < runs.rows(); ++f) {
      if (std::isfinite(runs(f, r))) sum[f] += runs(f, r), count[f] += 1;
    }
  }
  for (Index f = 0; f < runs.rows(); ++f) sum[f] = count[f] > 0 ? sum[f] / count[f] : otherwise[f];
  return sum;
}

double shrunk(double base, double repaired) { return base > 0 ? 1 - std::sqrt(std::max(0.0, repaired) / base) : -INFINITY; }

MatrixXd root_of(const MatrixXd& covariance) { return Eigen::LLT<MatrixXd>(covariance).matrixL(); }

}  // namespace

SquaredGap squared_gap(const Target& target, const MatrixXd& runs, std::uint64_t seed) {
  const Summary s = summary_of(runs);
  const VectorXd variance = target.covariance.diagonal(), noise = variance + s.variance.cwiseQuotient(s.n);
  SquaredGap out{.value = mean_square(target.y - s.mean, noise, variance, s.n)};
  const MatrixXd root = root_of(target.covariance);
  std::vector<double> chance;
  for (int b = 0; b < kResamples; ++b) {
    // A bootstrapped mean scatters by (n - 1)/n of what a mean of n runs does.
    const VectorXd wide = (s.n.array() / (s.n.array() - 1).max(1)).sqrt();
    const VectorXd apart = (resampled_mean(runs, s.mean, seed, kNullStream, b) - s.mean).cwiseProduct(wide);
    chance.push_back(mean_square(root * normals(target.y.size(), seed, kNullErrorStream + b) - apart, noise, variance, s.n));
  }
  out.noise_95 = quantile(std::move(chance), 0.95);
  return out;
}

Shrinkage shrinkage_of(const Target& target, const MatrixXd& base, const MatrixXd& repaired, std::uint64_t seed) {
  Shrinkage out{.base = squared_gap(target, base, seed), .repaired = squared_gap(target, repaired, seed + 1), .s = {}, .low = {}, .high = {}};
  if (!out.base.seen()) return out;
  out.s = shrunk(out.base.value, out.repaired.value);
  const MatrixXd root = root_of(target.covariance);
  const VectorXd variance = target.covariance.diagonal();
  const Summary before = summary_of(base), after = summary_of(repaired);
  // The noise of the figures themselves, and that of drawing them anew: their errors once more, their runs (n - 1)/n as much.
  const auto noise_of = [&](const Summary& s) {
    return VectorXd(2 * variance.array() + s.variance.array() / s.n.array() * (1 + (s.n.array() - 1) / s.n.array()));
  };
  const VectorXd noise_before = noise_of(before), noise_after = noise_of(after);
  std::vector<double> all;
  for (int b = 0; b < kResamples; ++b) {
    const VectorXd y = target.y + root * normals(target.y.size(), seed, kErrorStream + b);
    const double g0 = mean_square(y - resampled_mean(base, before.mean, seed, kBaseStream, b), noise_before, variance, before.n);
    const double gk = mean_square(y - resampled_mean(repaired, after.mean, seed, kRepairedStream, b), noise_after, variance, after.n);
    all.push_back(shrunk(g0, gk));
  }
  const double low = quantile(all, 0.05), high = quantile(all, 0.95);
  if (std::isfinite(low)) out.low = low;
  if (std::isfinite(high)) out.high = high;
  return out;
}

}  // namespace regolab::gap
