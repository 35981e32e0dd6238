#include "scheduler/gap/blind/chance.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "digest/sha256.h"

namespace regolab::gap {

std::string Chance::next() {
  Sha256 digest;
  digest.add(secret_);
  digest.add("/" + label_ + "/" + std::to_string(counter_++));
  return digest.hex();
}

double Chance::uniform() {
  const std::string digits = next().substr(0, 13);  // 52 bits: a double holds them
  return static_cast<double>(std::strtoull(digits.c_str(), nullptr, 16)) * 0x1p-52;
}

double Chance::by_ratio(double low, double high) { return low * std::pow(high / low, uniform()); }

std::string Chance::hex(std::size_t digits) { return next().substr(0, digits); }

std::vector<std::size_t> Chance::order(std::size_t n) {
  std::vector<std::size_t> out(n);
  std::iota(out.begin(), out.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(out[i - 1], out[below(i)]);
  return out;
}

double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return std::strtod(text, nullptr);
}

}  // namespace regolab::gap
