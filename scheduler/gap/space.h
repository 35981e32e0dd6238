/// The micro-parameters that calibration may move, as processes see them.
#pragma once
#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "scheduler/gap/bank.h"
#include "scheduler/gap/shared_gp.h"

namespace regolab::gap {

/// A number between two ends, or one of some values (N_E, rotation: their numbers).
struct Axis {
  std::string name;
  double low = 0, high = 0;     ///< of the bank [SI]
  std::vector<double> choices;  ///< not empty: a choice
  bool is_choice() const { return !choices.empty(); }
};

/// theta_F, K_N, eta_N, K_T, eta_T, L_S, gravity, N_E, rotation, as far as the bank varies them.
struct Space {
  std::vector<Axis> axes;
  std::map<std::string, double> fixed;  ///< inputs that never vary, by name [SI]

  std::size_t size() const { return axes.size(); }
  /// -1 when there is none.
  int find(const std::string& name) const;
  /// Value at share u of the axis, u in [0, 1).
  double value(std::size_t axis, double u) const;
  /// [n_points][n_inputs] of values [n_axes][n_points]: numbers to [0, 1], choices one-hot; `extra` more columns stay free on the right.
  Eigen::MatrixXd scaled(const Eigen::MatrixXd& values, int extra = 0) const;
  /// Which inputs share a length, extra ones have their own.
  Groups groups(int extra = 0) const;
};

/// From the rows of the bank; an axis that never varies is left out, and stands in `fixed`.
Space space_of(const Bank& bank);

}  // namespace regolab::gap
