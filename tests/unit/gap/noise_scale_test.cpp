#include "scheduler/gap/noise_scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 120 materials of two inputs; the ratio of each scatters as that of two repeats over a few features does.
struct Materials {
  MatrixXd x{120, 2};
  VectorXd ratio{120};
  explicit Materials(double slope) {
    for (Index i = 0; i < 120; ++i) {
      const double k = static_cast<double>(i);
      x.row(i) << std::fmod(0.5 + 0.7549 * k, 1.0), std::fmod(0.5 + 0.5698 * k, 1.0);
      ratio[i] = std::exp(slope * (x(i, 0) - 0.5) + 0.6 * std::sin(137 * k + 1));
    }
    ratio /= ratio.mean();
  }
};

TEST(NoiseScale, FollowsMaterialsThatScatterMore) {
  const Materials m(2.5);
  const NoiseScale scale(m.x, m.ratio);
  MatrixXd ends(2, 2);
  ends << 0.1, 0.5, 0.9, 0.5;
  const VectorXd at = scale.at(ends);
  EXPECT_NEAR(std::log(at[1] / at[0]), 2.5 * 0.8, 0.4);
  EXPECT_NEAR(scale.at(m.x).mean(), 1, 0.02) << "in units of the mean over materials";
}

TEST(NoiseScale, IsOneWhereRepeatsForetellNothing) {
  const Materials m(0);
  EXPECT_TRUE(NoiseScale(m.x, m.ratio).at(m.x).isOnes(0));
  EXPECT_TRUE(NoiseScale().at(m.x).isOnes(0));
}

TEST(NoiseScale, FewMaterialsSayNothing) {
  Materials m(2.5);
  m.ratio.tail(110).setConstant(NAN);
  EXPECT_TRUE(NoiseScale(m.x, m.ratio).at(m.x).isOnes(0));
}

}  // namespace
}  // namespace regolab::gap
