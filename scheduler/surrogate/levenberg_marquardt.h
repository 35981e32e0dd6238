/// Least squares by Levenberg and Marquardt, with a penalty on the weights whose strength may be found from the data.
/// Single-threaded and without random numbers: the same problem gives the same bits.
#pragma once
#include <Eigen/Dense>
#include <functional>

namespace regolab::surrogate {

/// Minimise |residual(w)|^2 + penalty * sum of squares of the penalised weights.
struct LeastSquares {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& w)> residual;  // [n] model less data
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& w)> jacobian;  // [n][weights] of the residual
  Eigen::VectorXd penalised;                                          // [weights] 1 or 0; empty = none
};

enum class Penalty {
  kFixed,     ///< stays at FitOptions::penalty
  kEvidence,  ///< re-estimated after every step so that the data are most likely [MacKay 1992, 10.1162/neco.1992.4.3.415;
              ///< with LM: Foresee and Hagan 1997, 10.1109/ICNN.1997.614194]
};

struct FitOptions {
  Penalty mode = Penalty::kFixed;
  double penalty = 0;      ///< of kFixed, or where kEvidence starts
  double independent = 0;  ///< of kEvidence: how many of the n residuals count as independent; 0 = all
  int max_steps = 300;
  /// Early stopping: the error on rows held back; empty = none. The weights with the smallest error are kept, and the fit
  /// ends when `patience` steps in a row brought no smaller one.
  std::function<double(const Eigen::VectorXd& w)> watched;
  int patience = 30;
};

enum class FitEnd { kConverged, kEarlyStopped, kStepLimit, kNoDescent };

struct Fit {
  Eigen::VectorXd w;          // [weights]
  double sum_of_squares = 0;  ///< |residual(w)|^2
  double penalty = 0;         ///< as it came to be
  double weights_in_use = 0;  ///< gamma: weights that the data determine rather than the penalty
  double watched = 0;         ///< its smallest value; 0 without early stopping
  int steps = 0;              ///< taken
  FitEnd end = FitEnd::kStepLimit;
};

/// REQUIRES: n >= 1; residual and jacobian finite at w.
Fit fit_least_squares(const LeastSquares& problem, Eigen::VectorXd w, const FitOptions& options);

}  // namespace regolab::surrogate
