/// Predictive densities as mixtures of normals, and how much a draw from one of several tells which it was.
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <span>
#include <vector>

namespace regolab::gap {

/// Sum of weight_j N(mean_j, covariance_j).
class Mixture {
 public:
  explicit Mixture(Eigen::Index size) : size_(size) {}

  /// Weights need not sum to 1. REQUIRES: covariance [d][d] positive definite.
  void add(double weight, const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance);
  /// Spreads each component by a share of the scatter of all means, and draws the means together by as much, so that mean and covariance of
  /// the whole stay: a mixture from draws is then no comb of them [West 1993; the share: Silverman 1986, eq. 4.14].
  void smooth();

  /// [n] of points [d][n].
  Eigen::VectorXd log_density(const Eigen::MatrixXd& points) const;
  /// [d][n]; the same seed and stream give the same draws.
  Eigen::MatrixXd draws(Eigen::Index n, std::uint64_t seed, std::uint64_t stream) const;
  Eigen::Index size() const { return size_; }

 private:
  struct Component {
    double weight;
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance, lower;
  };
  Eigen::Index size_;
  std::vector<Component> components_;
};

struct Information {
  double nats = 0, error = 0;  ///< expected fall of the entropy, and its Monte Carlo standard error
  Eigen::MatrixXd apart;       ///< [n][n] of two alone: the share of their own entropy that is expected to go
};

/// I(which; y) = sum p_k E_k[log f_k(y) - log sum p_i f_i(y)], for y drawn from f_k with probability p_k: by Monte Carlo, `draws` in all,
/// spread over the k. probability sums to 1.
Information information(std::span<const Mixture> densities, std::span<const double> probability, int draws, std::uint64_t seed);

}  // namespace regolab::gap
