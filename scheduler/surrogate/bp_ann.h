/// The article's prediction functions BP-ANN-1, -2 and -3 [article Sec. 3.2, Fig. 14]: trained, measured, used.
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <optional>
#include <vector>

#include "scheduler/surrogate/bp_ann_data.h"
#include "scheduler/surrogate/levenberg_marquardt.h"
#include "scheduler/surrogate/network.h"

namespace regolab::surrogate {

/// Tests (points of the table) for training, validation and test: 70, 15 and 15 %, drawn at random.
struct Split {
  std::vector<int> training;
  std::vector<int> validation;
  std::vector<int> test;
};

/// Rows of one test stay together. The same tests and seed give the same split. Each list ascends.
/// REQUIRES: at least kFewestTests different tests.
Split split_tests(const std::vector<int>& tests, std::uint64_t seed);

/// Rows whose test is among `wanted`, which ascends.
std::vector<Eigen::Index> rows_of(const std::vector<int>& test, const std::vector<int>& wanted);

/// One network or the mean of several.
struct AnnModel {
  NetworkShape shape;
  std::vector<Fit> members;

  /// Normalised outputs for normalised inputs x [n][n_inputs]. [n][n_outputs]
  Eigen::MatrixXd predict(const Eigen::MatrixXd& x) const;
};

struct SplitTraining {
  AnnModel model;  ///< one member
  int chosen = 0;  ///< 1-based start
};

/// As the article trains: Levenberg-Marquardt from `starts` random starts, stopped early. Kept, among steps and starts, is
/// the network whose larger mean squared error of the two, training or validation, is the smallest: five validation tests
/// alone would often prefer a network that has learnt nothing yet. The test group has no say.
SplitTraining train_on_split(const AnnData& data, const Split& split, const NetworkShape& shape, int starts,
                             std::uint64_t seed);

/// The mean of `members` networks, each fitted to all rows with a penalty from the evidence, for which a test counts once,
/// however many pressures it has, because its errors go together. Nothing is held back.
AnnModel train_ensemble(const AnnData& data, const NetworkShape& shape, int members, std::uint64_t seed);

/// Hidden units of all three functions: the fewest with which the training R reaches the article's for each of ten seeds.
inline constexpr int kHiddenUnits = 3;

/// How much is tried. Less for thousands of rows, where one network takes seconds and starts differ little.
struct TrainEffort {
  int starts = 40;  ///< on the split
  int members = 6;  ///< networks averaged where no validation tests are held back
  int folds = 0;    ///< sets of tests left out in turn
};
/// One test at a time up to 64 tests, ten sets of tests beyond.
TrainEffort effort_for(const AnnData& data);

/// Every test predicted by an ensemble that saw none of its rows. With fewer folds than tests, tests are left out in sets
/// drawn at random. [n][n_outputs] normalised
Eigen::MatrixXd leave_tests_out(const AnnData& data, const NetworkShape& shape, const TrainEffort& effort,
                                std::uint64_t seed);

/// How predictions stand to the data.
struct FitQuality {
  int rows = 0;
  std::optional<double> r;   ///< Pearson's; nothing with fewer than two rows or without spread
  std::optional<double> r2;  ///< 1 - squared error / squared deviation from the rows' own mean
  double rms = 0;            ///< error, in the unit of the data
  double relative = 0;       ///< rms over the mean of the data
};

/// REQUIRES: one length. [n]
FitQuality quality_of(const Eigen::VectorXd& data, const Eigen::VectorXd& predicted);

}  // namespace regolab::surrogate
