#include <algorithm>
#include <cmath>

#include "scheduler/gap/diagnosis.h"
#include "scheduler/gap/draws.h"
#include "scheduler/gap/tangent.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPoints = 20;       // over the prior
constexpr std::uint64_t kStream = 98;
constexpr double kNoticed = 1;    // [sigma] that calibration does not absorb
constexpr int kLevels = 12;       // of strength, for the least that is noticed

double median(std::vector<double> v) {
  std::ranges::nth_element(v, v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2));
  return v[v.size() / 2];
}

/// One point of the prior of the base model.
class Point {
 public:
  Point(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed, int point)
      : emulator_(emulator), comparison_(comparison), stated_(stated), base_(emulator, comparison, {"none", {}, false, {}}, stated),
        at_(point_of(base_.parameters(), seed, point)), tangent_(base_, comparison, at_) {}

  /// What is left of the shifts of one cause at these shares of its range. [q][n_shares]
  MatrixXd shifts(std::size_t cause, const StrengthRange& range, const VectorXd& shares) const {
    const Likelihood with(emulator_, comparison_, {"", {cause}, false, {range}}, stated_);
    MatrixXd v(at_.size() + 1, shares.size());
    v.topRows(at_.size()) = at_.replicate(1, shares.size());
    v.bottomRows(1) = shares.transpose();
    return tangent_.left(tangent_.whitened(with.predict(v).mean.colwise() - tangent_.mean()));
  }

 private:
  static VectorXd point_of(int d, std::uint64_t seed, int point) {
    VectorXd at(d);
    for (Index k = 0; k < d; ++k) at[k] = uniform(seed, kStream, static_cast<std::uint64_t>(point), static_cast<std::uint64_t>(k));
    return at;
  }

  const Emulator& emulator_;
  const Comparison& comparison_;
  const std::map<std::string, Stated>& stated_;
  Likelihood base_;
  VectorXd at_;
  Tangent tangent_;
};

/// The smallest strength whose shift is noticed at the median point; the largest of the prior where none is.
double least_noticed(const std::vector<Point>& points, const Cause& cause, std::size_t index) {
  const double high = std::max(std::abs(cause.effect->prior_low), std::abs(cause.effect->prior_high));
  const double low = cause.effect->prior_low > 0 ? cause.effect->prior_low : 0.01 * high;
  VectorXd shares(kLevels);
  for (int k = 0; k < kLevels; ++k) shares[k] = static_cast<double>(k) / (kLevels - 1);
  std::vector<std::vector<double>> norms(kLevels);
  const bool both = cause.effect->prior_low < 0;
  for (const Point& point : points) {
    const MatrixXd up = point.shifts(index, {.low = low, .high = high, .logarithmic = true}, shares);
    const MatrixXd down = both ? point.shifts(index, {.low = -low, .high = -high, .logarithmic = true}, shares) : up;
    for (int k = 0; k < kLevels; ++k) norms[static_cast<std::size_t>(k)].push_back(0.5 * (up.col(k).norm() + down.col(k).norm()));
  }
  for (int k = 0; k < kLevels; ++k) {
    if (median(norms[static_cast<std::size_t>(k)]) >= kNoticed) return low * std::pow(high / low, shares[k]);
  }
  return high;
}

}  // namespace

std::vector<Isolability> isolability(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed) {
  const std::size_t n = emulator.causes().size();
  std::vector<Point> points;
  points.reserve(kPoints);
  for (int k = 0; k < kPoints; ++k) points.emplace_back(emulator, comparison, stated, seed, k);
  std::vector<std::vector<double>> sigma(n);
  std::vector<std::vector<std::vector<double>>> cosine(n, std::vector<std::vector<double>>(n));
  for (int k = 0; k < kPoints; ++k) {
    MatrixXd s(comparison.size(), static_cast<Index>(n));
    for (std::size_t c = 0; c < n; ++c) {
      const double share = uniform(seed, kStream, static_cast<std::uint64_t>(k), 1000 + c);
      s.col(static_cast<Index>(c)) = points[static_cast<std::size_t>(k)].shifts(c, StrengthRange::of(emulator.causes()[c]), VectorXd::Constant(1, share));
    }
    const MatrixXd unit = s.colwise().normalized();
    for (std::size_t a = 0; a < n; ++a) {
      sigma[a].push_back(s.col(static_cast<Index>(a)).norm());
      for (std::size_t b = 0; b < n; ++b) cosine[a][b].push_back(std::abs(unit.col(static_cast<Index>(a)).dot(unit.col(static_cast<Index>(b)))));
    }
  }
  std::vector<Isolability> out;
  for (std::size_t a = 0; a < n; ++a) {
    const Cause& cause = emulator.causes()[a];
    Isolability one{.effect = std::string(cause.effect->name), .sigma = median(sigma[a]), .least = least_noticed(points, cause, a), .twin = {}};
    one.seen = one.least < std::max(std::abs(cause.effect->prior_low), std::abs(cause.effect->prior_high));
    for (std::size_t b = 0; b < n; ++b) {
      const double alike = median(cosine[a][b]);
      if (b != a && alike > one.cosine) one.cosine = alike, one.twin = std::string(emulator.causes()[b].effect->name);
    }
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace regolab::gap
