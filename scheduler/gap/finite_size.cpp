#include "scheduler/gap/finite_size.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kFewest = 8;

}  // namespace

double usual_size(const Bank& bank) {
  const auto particles = bank.input("particles");
  if (!particles) return 0;
  std::map<double, int> rows;
  for (const BankRow& row : bank.rows) ++rows[row.inputs[*particles]];
  return rows.empty() ? 0 : std::ranges::max_element(rows, {}, &std::pair<const double, int>::second)->first;
}

Bank of_size(const Bank& bank, double particles) {
  Bank out{bank.inputs, bank.features, {}};
  const auto input = bank.input("particles");
  std::ranges::copy_if(bank.rows, std::back_inserter(out.rows), [&](const BankRow& row) { return !input || row.inputs[*input] == particles; });
  return out;
}

FiniteSize::FiniteSize(double usual, const VectorXd& particles, const MatrixXd& residual, const MatrixXd& foretold)
    : usual_(usual), slope_(VectorXd::Zero(residual.cols())), slope_variance_(slope_), spread_(slope_) {
  const VectorXd x = 1 - usual / particles.array();
  for (Index j = 0; j < residual.cols(); ++j) {
    double xx = 0, xy = 0, yy = 0, chance = 0;
    int n = 0;
    for (Index i = 0; i < residual.rows(); ++i) {
      if (const double y = residual(i, j); std::isfinite(y)) xx += x[i] * x[i], xy += x[i] * y, yy += y * y, chance += foretold(i, j), ++n;
    }
    if (n < kFewest || xx == 0) continue;
    slope_[j] = xy / xx;
    const double left = (yy - slope_[j] * xy) / (n - 1);
    slope_variance_[j] = left / xx;
    spread_[j] = std::max(0.0, left - chance / n) / (xx / n);
  }
}

Predicted FiniteSize::at(double particles) const {
  const double x = usual_ > 0 ? 1 - usual_ / particles : 0;
  return {slope_ * x, (slope_variance_ + spread_) * (x * x)};
}

}  // namespace regolab::gap
