/// A result table as the article's prediction functions see it: which factors go in, which responses come out, normalised.
#pragma once
#include <Eigen/Dense>
#include <string>
#include <vector>

#include "vocab/result.h"
#include "vocab/result_table.h"

namespace regolab::surrogate {

struct AnnOutput {
  std::string response;  ///< "sigma1" stands for all confining pressures
  std::string unit;      ///< door unit
  double constant = 1;   ///< normalised = value in door unit / constant [article Eq. 4, Table 11]
};

/// The rows one function can be trained on.
struct AnnData {
  std::vector<std::string> inputs;  // [n_inputs] "theta_F", "N_E=2", ...
  std::vector<AnnOutput> outputs;   // [n_outputs]
  std::vector<int> test;            // [n] the table's point; the four pressures of a test are rows of one test
  Eigen::MatrixXd x;                // [n][n_inputs] normalised
  Eigen::MatrixXd y;                // [n][n_outputs] normalised
};

/// Fewer tests leave nothing to hold back: 70 / 15 / 15 of 12 are 8, 2 and 2.
inline constexpr int kFewestTests = 12;

/// Data of BP-ANN-`function` (1, 2 or 3); replicate seeds of a point are averaged, points without a number are left out.
/// Errors: kFailedPrecondition when a factor or response is not in the table, when fewer than kFewestTests tests are left,
/// or when a number is not finite; kInvalidArgument for another function.
Result<AnnData> ann_data(const ResultTable& table, int function);

/// The article's tables for training: void ratios are 2.93/density - 1 of the printed density, because Table 5 contradicts
/// itself for test 26 (1.68 g/cm3 is e = 0.74, printed 0.79; the other 31 agree to 0.01).
ResultTable article_training_table();

}  // namespace regolab::surrogate
