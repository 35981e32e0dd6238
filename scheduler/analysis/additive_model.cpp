#include "scheduler/analysis/additive_model.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <set>
#include <utility>

namespace regolab::analysis {
namespace {

constexpr double kSingular = 1e-10;  // eigenvalues of X'X below this share of the largest count as zero
constexpr double kExact = 1e-20;     // residuals below this share of sum y^2 are rounding, not error

struct PseudoInverse {
  Eigen::MatrixXd matrix;
  int rank = 0;
};

PseudoInverse pseudo_inverse(const Eigen::MatrixXd& normal) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(normal);
  const Eigen::VectorXd& values = solver.eigenvalues();
  const double least = kSingular * values.maxCoeff();
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(values.size());
  PseudoInverse result;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] <= least) continue;
    inverse[i] = 1 / values[i];
    ++result.rank;
  }
  result.matrix = solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
  return result;
}

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

std::optional<double> tail(double sum, int df, double rss, int error_df) {
  if (df <= 0 || error_df <= 0 || rss <= 0) return std::nullopt;
  return f_tail(sum / df / (rss / error_df), df, error_df);
}

}  // namespace

double f_tail(double f, int numerator, int denominator) {
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f(numerator, denominator), std::max(f, 0.0)));
}

double t_95(int degrees_of_freedom) { return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975); }

AdditiveModel::AdditiveModel(std::vector<int> levels, std::vector<std::vector<int>> rows, std::vector<double> y)
    : levels_(std::move(levels)), rows_(std::move(rows)), y_(std::move(y)) {
  int columns = 1;  // mu
  for (std::size_t factor = 0; factor < levels_.size(); ++factor) {
    std::set<int> present;
    for (const auto& row : rows_) present.insert(row[factor]);
    blocks_.push_back({columns, {present.begin(), present.end()}});
    columns += blocks_.back().size();
  }
  x_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows_.size()), columns);
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    x_(static_cast<Eigen::Index>(run), 0) = 1;
    for (std::size_t factor = 0; factor < levels_.size(); ++factor) {
      x_.row(static_cast<Eigen::Index>(run)) += level_code(blocks_[factor], rows_[run][factor]).transpose();
    }
  }
  fit();
}

void AdditiveModel::fit() {
  const Eigen::Map<const Eigen::VectorXd> y(y_.data(), static_cast<Eigen::Index>(y_.size()));
  PseudoInverse inverse = pseudo_inverse(x_.transpose() * x_);
  rank_ = inverse.rank;
  inverse_ = std::move(inverse.matrix);
  beta_ = inverse_ * (x_.transpose() * y);
  residual_ = y - x_ * beta_;
  rss_ = residual_.squaredNorm();
  if (rss_ <= kExact * y.squaredNorm() || error_degrees_of_freedom() <= 0) rss_ = 0;
}

double AdditiveModel::residual_standard_deviation() const {
  const int df = error_degrees_of_freedom();
  return df > 0 ? std::sqrt(rss_ / df) : 0;
}

Eigen::VectorXd AdditiveModel::level_code(const Block& block, int level) const {
  Eigen::VectorXd code = Eigen::VectorXd::Zero(x_.cols());
  if (level == block.present.back()) {
    code.segment(block.first, block.size()).setConstant(-1);  // the last level's effect is less the sum of the others
  } else {
    const auto at = std::ranges::find(block.present, level) - block.present.begin();
    code[block.first + at] = 1;
  }
  return code;
}

std::vector<double> AdditiveModel::level_effects(const Block& block, const Eigen::VectorXd& beta) const {
  std::vector<double> effects;
  for (const int level : block.present) effects.push_back(level_code(block, level).dot(beta));
  return effects;
}

int AdditiveModel::rank_without(std::size_t factor, double& rss) const {
  const Block& block = blocks_[factor];
  const Eigen::Index after = x_.cols() - block.first - block.size();
  Eigen::MatrixXd reduced(x_.rows(), x_.cols() - block.size());
  reduced << x_.leftCols(block.first), x_.rightCols(after);
  const Eigen::Map<const Eigen::VectorXd> y(y_.data(), static_cast<Eigen::Index>(y_.size()));
  const PseudoInverse inverse = pseudo_inverse(reduced.transpose() * reduced);
  rss = (y - reduced * (inverse.matrix * (reduced.transpose() * y))).squaredNorm();
  return inverse.rank;
}

Effect AdditiveModel::effect(std::size_t factor) const {
  const Block& block = blocks_[factor];
  Effect effect;
  effect.mean.assign(static_cast<std::size_t>(levels_[factor]), 0);
  effect.mean_scale.assign(effect.mean.size(), 0);
  double rss_without = 0;
  effect.degrees_of_freedom = rank_ - rank_without(factor, rss_without);
  effect.sum_of_squares = std::max(0.0, rss_without - residual_.squaredNorm());
  effect.estimable = effect.degrees_of_freedom == block.size();
  effect.p = tail(effect.sum_of_squares, effect.degrees_of_freedom, rss_, error_degrees_of_freedom());
  if (effect.p) effect.f = effect.sum_of_squares / effect.degrees_of_freedom / (rss_ / error_degrees_of_freedom());

  std::vector<double> shown;
  for (const int level : block.present) {
    const auto at = static_cast<std::size_t>(level);
    if (full_rank()) {
      Eigen::VectorXd code = level_code(block, level);
      code[0] = 1;
      effect.mean[at] = code.dot(beta_);
      effect.mean_scale[at] = std::sqrt(std::max(0.0, code.dot(inverse_ * code)));
    } else {
      double sum = 0;
      int runs = 0;
      for (std::size_t run = 0; run < rows_.size(); ++run) {
        if (rows_[run][factor] != level) continue;
        sum += y_[run];
        ++runs;
      }
      effect.mean[at] = sum / runs;
    }
    shown.push_back(effect.mean[at]);
  }
  // Where other factors are mixed up, this one's differences may still be sound: they come from its own coefficients.
  if (!full_rank() && effect.estimable) {
    const std::vector<double> effects = level_effects(block, beta_);
    double centre = 0;
    for (const double y : y_) centre += y / static_cast<double>(y_.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
      shown[i] = centre + effects[i];
      effect.mean[static_cast<std::size_t>(block.present[i])] = shown[i];
    }
  }
  effect.range = spread(shown);
  return effect;
}

std::optional<AdditiveModel::Without> AdditiveModel::without(std::size_t run, std::size_t factor) const {
  // Dropping row x with residual e and leverage h: beta - G x e/(1-h), G + G x x'G/(1-h), rss - e^2/(1-h)
  // (Belsley, Kuh, Welsch, Regression Diagnostics, 1980, Sec. 2.1).
  const Block& block = blocks_[factor];
  const Eigen::VectorXd x = x_.row(static_cast<Eigen::Index>(run)).transpose();
  const Eigen::VectorXd gx = inverse_ * x;
  const double spare = 1 - x.dot(gx);
  const double e = residual_[static_cast<Eigen::Index>(run)];
  constexpr double kLeast = 1e-9;  // leverage 1: some coefficient rests on this run alone
  if (!full_rank() || spare <= kLeast || block.size() < 1) return std::nullopt;
  const Eigen::VectorXd beta = beta_ - gx * (e / spare);
  const Eigen::MatrixXd own =
      inverse_.block(block.first, block.first, block.size(), block.size()) +
      gx.segment(block.first, block.size()) * gx.segment(block.first, block.size()).transpose() / spare;
  const Eigen::VectorXd coefficients = beta.segment(block.first, block.size());
  const double sum_of_squares = coefficients.dot(own.ldlt().solve(coefficients));
  const double rss = rss_ > 0 ? rss_ - e * e / spare : 0;
  return Without{.range = spread(level_effects(block, beta)),
                 .p = tail(sum_of_squares, block.size(), rss, error_degrees_of_freedom() - 1)};
}

std::vector<double> AdditiveModel::contrast_weights(std::size_t factor, int high, int low) const {
  const Block& block = blocks_[factor];
  const Eigen::VectorXd difference = level_code(block, high) - level_code(block, low);
  const Eigen::VectorXd weights = x_ * (inverse_ * difference);
  return {weights.begin(), weights.end()};
}

}  // namespace regolab::analysis
