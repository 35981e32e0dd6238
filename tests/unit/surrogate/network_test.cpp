#include "scheduler/surrogate/network.h"

#include <gtest/gtest.h>

#include <cmath>

namespace regolab::surrogate {
namespace {

Eigen::MatrixXd sample_inputs() {
  Eigen::MatrixXd x(3, 2);
  x << 0.1, 0.9, 0.5, 0.2, 1.0, 0.7;
  return x;
}

TEST(Network, WithoutHiddenWeightsAnswersItsOutputBiases) {
  const NetworkShape shape{2, 3, 2};
  Eigen::VectorXd w = Eigen::VectorXd::Zero(shape.weights());
  w.tail(2) << 0.25, -1.5;
  const Eigen::MatrixXd y = network_forward(shape, w, sample_inputs());
  EXPECT_TRUE((y.col(0).array() == 0.25).all());
  EXPECT_TRUE((y.col(1).array() == -1.5).all());
}

TEST(Network, OneHiddenUnitIsTheFormula) {
  const NetworkShape shape{2, 1, 1};
  Eigen::VectorXd w(5);
  w << 0.3, -0.7, 0.2, 1.5, 0.4;  // hidden weights, hidden bias, output weight, output bias
  const Eigen::MatrixXd y = network_forward(shape, w, sample_inputs());
  EXPECT_DOUBLE_EQ(y(1, 0), 1.5 * std::tanh(0.3 * 0.5 - 0.7 * 0.2 + 0.2) + 0.4);
}

TEST(Network, JacobianAgreesWithCentralDifferences) {
  const NetworkShape shape{2, 4, 3};
  const Eigen::MatrixXd x = sample_inputs();
  const Eigen::VectorXd w = 2 * network_start(shape, 5, 0);
  const Eigen::MatrixXd jacobian = network_jacobian(shape, w, x);
  ASSERT_EQ(jacobian.rows(), 9);
  ASSERT_EQ(jacobian.cols(), shape.weights());
  constexpr double kStep = 1e-5;
  for (int j = 0; j < shape.weights(); ++j) {
    Eigen::VectorXd up = w, down = w;
    up(j) += kStep;
    down(j) -= kStep;
    const Eigen::MatrixXd slope = (network_forward(shape, up, x) - network_forward(shape, down, x)) / (2 * kStep);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(jacobian(i * 3 + k, j), slope(i, k), 1e-9) << i << " " << k << " " << j;
    }
  }
}

TEST(Network, OnlyOutputBiasesEscapeThePenalty) {
  const NetworkShape shape{2, 3, 2};
  const Eigen::VectorXd mask = shape.penalised();
  EXPECT_EQ(mask.sum(), shape.weights() - 2);
  EXPECT_EQ(mask.tail(2).sum(), 0);
}

TEST(Network, StartsDifferByNumberAndSeedAndAreRepeatable) {
  const NetworkShape shape{3, 2, 1};
  EXPECT_EQ(network_start(shape, 1, 2), network_start(shape, 1, 2));
  EXPECT_NE(network_start(shape, 1, 2), network_start(shape, 1, 3));
  EXPECT_NE(network_start(shape, 1, 2), network_start(shape, 2, 2));
  EXPECT_LE(network_start(shape, 1, 2).cwiseAbs().maxCoeff(), 1.0);
}

}  // namespace
}  // namespace regolab::surrogate
