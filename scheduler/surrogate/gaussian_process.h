/// Gaussian process regression: a smooth function with an honest band, from few noisy runs [Rasmussen and Williams 2006, ch. 2, 5].
#pragma once
#include <Eigen/Dense>
#include <vector>

namespace regolab::surrogate {

/// Covariance of two points: a weak linear trend, a Matern 5/2 part with a length for each input, and noise that falls with the
/// number of runs behind a point. Logarithms, as the optimiser sees them.
struct Hyperparameters {
  std::vector<double> log_length;  ///< [n_inputs], inputs are scaled to [0, 1]
  double log_signal = 0;           ///< variance of the smooth part, of standardised outputs
  double log_trend = -2;           ///< variance of each slope
  double log_noise = -3;           ///< variance of one run
};

/// Observations. x: [n][n_inputs] scaled; y: [n]; runs: [n] behind each mean, in units of one of the smallest specimen.
struct Observations {
  Eigen::MatrixXd x;
  Eigen::VectorXd y;
  Eigen::VectorXd runs;
};

class GaussianProcess {
 public:
  /// Conditions on the observations. REQUIRES: at least 2 rows, y not constant, finite numbers.
  GaussianProcess(Observations observations, Hyperparameters hyperparameters);

  struct Prediction {
    double mean = 0;
    double variance = 0;  ///< of the material's own mean
    double noise = 0;     ///< variance that one run adds
  };
  Prediction predict(const Eigen::VectorXd& x) const;

  /// Each row predicted without its group, in closed form (hyperparameters kept). group: [n] rows of one number leave together, as
  /// the runs of one material in two profiles must. `variance` is of the latent mean.
  std::vector<Prediction> leave_groups_out(const std::vector<int>& group) const;

  const Hyperparameters& hyperparameters() const { return hyper_; }
  const Observations& observations() const { return data_; }

 private:
  Observations data_;
  Hyperparameters hyper_;
  double centre_ = 0, scale_ = 1;  // of y
  Eigen::VectorXd weights_;        // K^-1 (y - centre) / scale
  Eigen::MatrixXd lower_;          // Cholesky factor of K
  Eigen::MatrixXd scaled_, centred_;  // [n_inputs][n] in units of the lengths; from the middle of the box
};

/// Hyperparameters of largest posterior probability, from fixed starts: the same data give the same bits. Lengths have a broad
/// log-normal prior, so that an input that does nothing is left out instead of fitted.
Hyperparameters fit_hyperparameters(const Observations& observations);

/// Logarithm of the posterior (up to a constant) and its gradient, in the order of log_length, signal, trend, noise. Standardises y.
double log_posterior(const Observations& observations, const std::vector<double>& parameters, std::vector<double>* gradient);

}  // namespace regolab::surrogate
