#include "scheduler/surrogate/network.h"

#include "scheduler/surrogate/ann_random.h"

namespace regolab::surrogate {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The parts of the weight vector, looked at in place.
struct Parts {
  Eigen::Map<const RowMajor> hidden;                 // [hidden][inputs]
  Eigen::Map<const Eigen::RowVectorXd> hidden_bias;  // [hidden]
  Eigen::Map<const RowMajor> output;                 // [outputs][hidden]
  Eigen::Map<const Eigen::RowVectorXd> output_bias;  // [outputs]

  Parts(const NetworkShape& s, const Eigen::VectorXd& w)
      : hidden(w.data(), s.hidden, s.inputs),
        hidden_bias(w.data() + s.hidden * s.inputs, s.hidden),
        output(w.data() + s.hidden * (s.inputs + 1), s.outputs, s.hidden),
        output_bias(w.data() + s.hidden * (s.inputs + 1) + s.outputs * s.hidden, s.outputs) {}
};

Eigen::MatrixXd hidden_layer(const Parts& parts, const Eigen::MatrixXd& x) {
  Eigen::MatrixXd sums = x * parts.hidden.transpose();
  sums.rowwise() += parts.hidden_bias;
  return sums.unaryExpr([](double sum) { return std::tanh(sum); });  // the library's: Eigen's own is an approximation
}

}  // namespace

Eigen::VectorXd NetworkShape::penalised() const {
  Eigen::VectorXd mask = Eigen::VectorXd::Ones(weights());
  mask.tail(outputs).setZero();
  return mask;
}

Eigen::MatrixXd network_forward(const NetworkShape& shape, const Eigen::VectorXd& w, const Eigen::MatrixXd& x) {
  const Parts parts(shape, w);
  Eigen::MatrixXd y = hidden_layer(parts, x) * parts.output.transpose();
  y.rowwise() += parts.output_bias;
  return y;
}

Eigen::MatrixXd network_jacobian(const NetworkShape& shape, const Eigen::VectorXd& w, const Eigen::MatrixXd& x) {
  const Parts parts(shape, w);
  const Eigen::MatrixXd h = hidden_layer(parts, x);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(x.rows() * shape.outputs, shape.weights());
  const int biases = shape.hidden * shape.inputs;
  const int output = biases + shape.hidden;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    for (int k = 0; k < shape.outputs; ++k) {
      auto line = jacobian.row(i * shape.outputs + k);
      for (int j = 0; j < shape.hidden; ++j) {
        const double slope = parts.output(k, j) * (1 - h(i, j) * h(i, j));  // dy_k / d(sum of hidden unit j)
        line.segment(j * shape.inputs, shape.inputs) = slope * x.row(i);
        line(biases + j) = slope;
        line(output + k * shape.hidden + j) = h(i, j);
      }
      line(output + shape.outputs * shape.hidden + k) = 1;
    }
  }
  return jacobian;
}

Eigen::VectorXd network_start(const NetworkShape& shape, std::uint64_t seed, std::uint64_t start) {
  Eigen::VectorXd w(shape.weights());
  for (Eigen::Index i = 0; i < w.size(); ++i)
    w(i) = 2 * ann_uniform(seed, AnnPurpose::kStart, start, static_cast<std::uint64_t>(i)) - 1;
  return w;
}

}  // namespace regolab::surrogate
