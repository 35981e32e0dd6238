/// A network with one hidden layer of tanh and linear outputs: the shape of the article's BP-ANN [article Sec. 3.2.2].
/// It is arithmetic only: inputs and outputs are normalised (order 1, no unit), and the weights are passed in.
#pragma once
#include <Eigen/Dense>
#include <cstdint>

namespace regolab::surrogate {

/// Weights lie in one vector: hidden [hidden][inputs] by rows, hidden biases [hidden], output [outputs][hidden] by rows,
/// output biases [outputs].
struct NetworkShape {
  int inputs = 0;
  int hidden = 0;
  int outputs = 0;

  int weights() const { return hidden * (inputs + 1) + outputs * (hidden + 1); }
  /// 1 where a weight is held small by the penalty, 0 for the output biases, which only carry the mean. [weights]
  Eigen::VectorXd penalised() const;
};

/// Outputs for inputs x [rows][inputs]. [rows][outputs] REQUIRES: w has shape.weights() entries.
Eigen::MatrixXd network_forward(const NetworkShape& shape, const Eigen::VectorXd& w, const Eigen::MatrixXd& x);

/// Derivatives of every output by every weight; output k of row i is line i * outputs + k. [rows * outputs][weights]
Eigen::MatrixXd network_jacobian(const NetworkShape& shape, const Eigen::VectorXd& w, const Eigen::MatrixXd& x);

/// Random weights of start number `start`, uniform in [-1, 1): hidden units then bend inside the unit cube of the inputs
/// without being saturated. The same bits for the same (seed, start).
Eigen::VectorXd network_start(const NetworkShape& shape, std::uint64_t seed, std::uint64_t start);

}  // namespace regolab::surrogate
