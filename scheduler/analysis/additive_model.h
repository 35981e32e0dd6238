/// The additive model y = mu + a(level of A) + b(level of B) + ... + error, by least squares on whatever runs there are.
/// Balanced data give the classical analysis of variance; missing runs and unbalanced designs give type III sums.
#pragma once
#include <Eigen/Dense>
#include <optional>
#include <vector>

namespace regolab::analysis {

struct Effect {
  std::vector<double> mean;        // [n_levels] the model's mean at each level, other factors averaged
  std::vector<double> mean_scale;  // [n_levels] standard error of `mean` over the residual standard deviation
  double range = 0;                ///< largest less smallest mean over levels that have runs
  double sum_of_squares = 0;
  int degrees_of_freedom = 0;
  bool estimable = false;      ///< false: mixed up with other factors by the runs there are; the means are then plain ones
  std::optional<double> f, p;  ///< nothing without error degrees of freedom or without residual
};

class AdditiveModel {
 public:
  /// `levels` [n_factors] level counts; `rows` [n_runs][n_factors] 0-based levels; `y` [n_runs].
  /// REQUIRES: at least one run, rows and y of one length.
  AdditiveModel(std::vector<int> levels, std::vector<std::vector<int>> rows, std::vector<double> y);

  int error_degrees_of_freedom() const { return static_cast<int>(y_.size()) - rank_; }
  double residual_sum_of_squares() const { return rss_; }
  /// 0 when no degree of freedom is left.
  double residual_standard_deviation() const;

  Effect effect(std::size_t factor) const;

  /// What the factor's range and p become when one run is left out and the model fitted again; nothing when the effect could
  /// then not be told from the others. Uses the exact update of least squares for a dropped row, so that it is a refit.
  struct Without {
    double range = 0;
    std::optional<double> p;
  };
  std::optional<Without> without(std::size_t run, std::size_t factor) const;

  /// Weights w of the runs in the difference of two level means: mean(high) - mean(low) = sum w y. For standard errors.
  /// REQUIRES: the factor is estimable.
  std::vector<double> contrast_weights(std::size_t factor, int high, int low) const;

 private:
  struct Block {
    int first = 0;             ///< column of the factor's first coefficient
    std::vector<int> present;  ///< levels that have runs, ascending
    int size() const { return static_cast<int>(present.size()) - 1; }
  };

  void fit();
  int rank_without(std::size_t factor, double& rss) const;
  Eigen::VectorXd level_code(const Block& block, int level) const;  ///< the factor's part of a row, full length
  std::vector<double> level_effects(const Block& block, const Eigen::VectorXd& beta) const;  // [n_present]
  bool full_rank() const { return rank_ == x_.cols(); }

  std::vector<int> levels_;
  std::vector<std::vector<int>> rows_;
  std::vector<double> y_;
  std::vector<Block> blocks_;  // [n_factors]
  Eigen::MatrixXd x_;          // [n_runs][n_coefficients] sum-to-zero coding
  Eigen::MatrixXd inverse_;    ///< pseudo-inverse of X'X
  Eigen::VectorXd beta_;
  Eigen::VectorXd residual_;
  int rank_ = 0;
  double rss_ = 0;
};

/// Upper tail of the F distribution.
double f_tail(double f, int numerator, int denominator);

/// Two-sided 95 % quantile of Student's t.
double t_95(int degrees_of_freedom);

}  // namespace regolab::analysis
