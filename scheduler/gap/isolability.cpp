#include <algorithm>
#include <cmath>

#include "scheduler/gap/diagnosis.h"
#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPoints = 20;       // over the prior
constexpr std::uint64_t kStream = 98;
constexpr double kStep = 0.02;    // of the unit cube, for slopes

double median(std::vector<double> v) {
  std::ranges::nth_element(v, v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2));
  return v[v.size() / 2];
}

/// Whitened shifts of all causes at one point of the prior, what calibration can do taken out. [q][n_causes]
MatrixXd shifts_at(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed, int point) {
  const Likelihood base(emulator, comparison, {"none", {}, false}, stated);
  const auto d = static_cast<Index>(base.parameters());
  VectorXd at(d);
  for (Index k = 0; k < d; ++k) at[k] = kStep + (1 - 2 * kStep) * uniform(seed, kStream, static_cast<std::uint64_t>(point), static_cast<std::uint64_t>(k));
  MatrixXd u(d, 2 * d + 1);
  for (Index k = 0; k < 2 * d + 1; ++k) u.col(k) = at;
  for (Index k = 0; k < d; ++k) u(k, 2 * k) -= kStep, u(k, 2 * k + 1) += kStep;
  const Predicted p = base.predict(u);
  const VectorXd sd = (comparison.variance + p.variance.col(2 * d)).cwiseSqrt();
  const MatrixXd lower = Eigen::LLT<MatrixXd>(sd.asDiagonal() * comparison.correlation * sd.asDiagonal()).matrixL();
  const auto whitened = [&](const MatrixXd& m) { return MatrixXd(lower.triangularView<Eigen::Lower>().solve(m)); };
  MatrixXd slopes(comparison.size(), d);
  for (Index k = 0; k < d; ++k) slopes.col(k) = (p.mean.col(2 * k + 1) - p.mean.col(2 * k)) / (2 * kStep);
  const MatrixXd basis = whitened(slopes);
  // Calibration moves a parameter over its prior at most: a ridge of one prior width.
  const MatrixXd absorb = (basis.transpose() * basis + 12 * MatrixXd::Identity(d, d)).ldlt().solve(basis.transpose());
  MatrixXd out(comparison.size(), static_cast<Index>(emulator.causes().size()));
  for (std::size_t c = 0; c < emulator.causes().size(); ++c) {
    const Likelihood with(emulator, comparison, {"", {c}, false}, stated);
    MatrixXd v(d + 1, 1);
    v.topRows(d) = at;
    v(d, 0) = uniform(seed, kStream, static_cast<std::uint64_t>(point), 1000 + c);
    const VectorXd shift = whitened(with.predict(v).mean - p.mean.col(2 * d));
    out.col(static_cast<Index>(c)) = shift - basis * (absorb * shift);
  }
  return out;
}

}  // namespace

std::vector<Isolability> isolability(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed) {
  const std::size_t n = emulator.causes().size();
  std::vector<std::vector<double>> sigma(n);
  std::vector<std::vector<std::vector<double>>> cosine(n, std::vector<std::vector<double>>(n));
  for (int point = 0; point < kPoints; ++point) {
    const MatrixXd s = shifts_at(emulator, comparison, stated, seed, point);
    for (std::size_t a = 0; a < n; ++a) {
      const VectorXd one = s.col(static_cast<Index>(a));
      sigma[a].push_back(one.norm());
      for (std::size_t b = 0; b < n; ++b) {
        const VectorXd other = s.col(static_cast<Index>(b));
        cosine[a][b].push_back(std::abs(one.dot(other)) / std::max(1e-12, one.norm() * other.norm()));
      }
    }
  }
  std::vector<Isolability> out;
  for (std::size_t a = 0; a < n; ++a) {
    Isolability one{.effect = std::string(emulator.causes()[a].effect->name), .sigma = median(sigma[a]), .twin = {}};
    for (std::size_t b = 0; b < n; ++b) {
      const double alike = median(cosine[a][b]);
      if (b != a && alike > one.cosine) one.cosine = alike, one.twin = std::string(emulator.causes()[b].effect->name);
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace regolab::gap
