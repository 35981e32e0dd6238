/// The evidence of a model and draws from its posterior, by annealed sequential Monte Carlo: particles walk from the prior to the
/// posterior while the likelihood's power rises from 0 to 1 [Del Moral, Doucet and Jasra 2006, doi 10.1111/j.1467-9868.2006.00553.x].
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <functional>

namespace regolab::gap {

/// Log likelihood of each column of u. u: [n_parameters][n_points] in the unit cube, whose uniform measure is the prior.
using LogLikelihood = std::function<Eigen::VectorXd(const Eigen::MatrixXd& u)>;

struct SmcOptions {
  int particles = 1000;
  double kept = 0.7;       ///< effective share of the particles after a step of the power
  int moves = 4;           ///< random walks after each step
  int repeats = 3;         ///< independent runs: their scatter is the error of log Z
  std::uint64_t seed = 1;
};

struct Posterior {
  double log_z = 0;
  double log_z_error = 0;          ///< standard error over the repeats
  Eigen::MatrixXd u;               ///< [n_parameters][repeats * particles] equally weighted draws
  Eigen::VectorXd log_likelihood;  ///< of each draw
};

Posterior sample_posterior(const LogLikelihood& log_likelihood, int parameters, const SmcOptions& options);

double log_mean_exp(const Eigen::VectorXd& v);

/// Two samples of one posterior as one; the error of log Z is half of what they differ by.
Posterior together(const Posterior& one, const Posterior& other);

}  // namespace regolab::gap
