#include "scheduler/gap/blind/intervals.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numeric>

#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

constexpr int kResamples = 2000;
constexpr int kBins = 5;
constexpr std::uint64_t kSeed = 20251;

double quantile(std::vector<double> v, double share) {
  std::ranges::sort(v);
  return v[static_cast<std::size_t>(share * static_cast<double>(v.size() - 1) + 0.5)];
}

}  // namespace

Interval share_of(int hits, int n) {
  if (n == 0) return {};
  using Binomial = boost::math::binomial_distribution<>;
  return {static_cast<double>(hits) / n, Binomial::find_lower_bound_on_p(n, hits, 0.025), Binomial::find_upper_bound_on_p(n, hits, 0.025), n};
}

Interval bootstrap(int n, const std::function<double(const std::vector<int>& cases)>& figure) {
  if (n == 0) return {};
  std::vector<int> cases(static_cast<std::size_t>(n));
  std::iota(cases.begin(), cases.end(), 0);
  const double whole = figure(cases);
  std::vector<double> values;
  for (int r = 0; r < kResamples; ++r) {
    for (std::size_t k = 0; k < cases.size(); ++k) cases[k] = std::min(n - 1, static_cast<int>(n * uniform(kSeed, static_cast<std::uint64_t>(r), k)));
    values.push_back(figure(cases));
  }
  return {whole, quantile(values, 0.025), quantile(values, 0.975), n};
}

double mean(const std::vector<double>& v) { return v.empty() ? NAN : std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size()); }

double median(std::vector<double> v) {
  if (v.empty()) return NAN;
  std::ranges::sort(v);
  const std::size_t half = v.size() / 2;
  return v.size() % 2 == 1 ? v[half] : 0.5 * (v[half - 1] + v[half]);
}

double calibration_error(const std::vector<double>& confidence, const std::vector<bool>& right, const std::vector<int>& cases) {
  std::vector<int> order = cases;
  std::ranges::stable_sort(order, {}, [&](int k) { return confidence[static_cast<std::size_t>(k)]; });
  const auto n = static_cast<int>(order.size());
  double sum = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    double apart = 0;
    for (int k = bin * n / kBins; k < (bin + 1) * n / kBins; ++k) {
      const auto at = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
      apart += confidence[at] - (right[at] ? 1 : 0);
    }
    sum += std::abs(apart) / n;
  }
  return sum;
}

CalibrationFloor calibration_floor(const std::vector<double>& confidence) {
  if (confidence.empty()) return {};
  std::vector<int> cases(confidence.size());
  std::iota(cases.begin(), cases.end(), 0);
  std::vector<double> values;
  for (int r = 0; r < kResamples; ++r) {
    std::vector<bool> right;
    for (std::size_t k = 0; k < confidence.size(); ++k) right.push_back(uniform(kSeed + 1, static_cast<std::uint64_t>(r), k) < confidence[k]);
    values.push_back(calibration_error(confidence, right, cases));
  }
  return {mean(values), quantile(values, 0.95)};
}

}  // namespace regolab::gap
