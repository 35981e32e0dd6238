/// Figures with their uncertainty: shares with exact binomial intervals, means with bootstrap ones.
#pragma once
#include <functional>
#include <vector>

namespace regolab::gap {

struct Interval {
  double value = 0, low = 0, high = 0;  ///< 95 %
  int n = 0;                            ///< cases behind it; 0: not defined
};

/// Clopper and Pearson's interval.
Interval share_of(int hits, int n);

/// Of any figure of a sample of cases, by resampling the cases; `figure` gets indices. The same sample gives the same interval.
Interval bootstrap(int n, const std::function<double(const std::vector<int>& cases)>& figure);

double mean(const std::vector<double>& v);
double median(std::vector<double> v);  ///< of an even number the mean of the middle two

/// Mean over bins of |mean confidence - share right|, weighted by their cases; five bins of equal numbers of cases.
double calibration_error(const std::vector<double>& confidence, const std::vector<bool>& right, const std::vector<int>& cases);

/// What a judge whose confidence is right would have: mean and 95 % quantile over chance.
struct CalibrationFloor {
  double mean = 0, q95 = 0;
};
CalibrationFloor calibration_floor(const std::vector<double>& confidence);

}  // namespace regolab::gap
