#include "scheduler/gap/gp_block.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

TEST(GpBlock, ProductsAreThePlainOnes) {
  const MatrixXd a = MatrixXd::Random(37, 10), b = MatrixXd::Random(37, kBlock);
  Rows c;
  multiply(padded(a), b, c);
  ASSERT_EQ(c.rows(), 12) << "padded to whole tiles";
  EXPECT_TRUE(MatrixXd(c.topRows(10)).isApprox(a.transpose() * b, 1e-14));
  EXPECT_TRUE(c.bottomRows(2).isZero(0));
}

/// From runs that coincide with the point to those beyond any length.
TEST(GpBlock, MaternIsTheFormulaAtAnyDistance) {
  Rows run(5, 2), point(2, kBlock), c = Rows::Constant(5, kBlock, 0.25);
  run << 0, 0, 0.3, 0.1, 2, -1, 40, 3, 1e4, 0;
  for (Index q = 0; q < kBlock; ++q) point(0, q) = 0.11 * static_cast<double>(q % 7), point(1, q) = -0.05 * static_cast<double>(q % 5);
  add_matern(run, point, c);
  for (Index r = 0; r < 5; ++r) {
    for (Index q = 0; q < kBlock; ++q) {
      const double t = std::sqrt(5.0) * (run.row(r).transpose() - point.col(q)).norm(), plain = 0.25 + (1 + t + t * t / 3) * std::exp(-t);
      ASSERT_NEAR(c(r, q), plain, 1e-13) << r << " " << q;
    }
  }
}

}  // namespace
}  // namespace regolab::gap
