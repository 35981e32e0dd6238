/// Random numbers of a set: functions of 32 secret bytes and a label, so that one secret makes the whole set and nothing else can.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace regolab::gap {

class Chance {
 public:
  /// SHA-256 in counter mode over (secret, label).
  Chance(std::string secret, std::string label) : secret_(std::move(secret)), label_(std::move(label)) {}

  double uniform();  ///< in [0, 1)
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double by_ratio(double low, double high);  ///< uniform in the logarithm
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform() * static_cast<double>(n)); }
  bool coin() { return uniform() < 0.5; }
  std::string hex(std::size_t digits);  ///< at most 64

  /// 0 ... n-1 in random order.
  std::vector<std::size_t> order(std::size_t n);

 private:
  std::string next();  ///< 64 hexadecimal digits

  std::string secret_, label_;
  std::uint64_t counter_ = 0;
};

/// To five significant digits: what is written is what is run.
double rounded(double value);

}  // namespace regolab::gap
