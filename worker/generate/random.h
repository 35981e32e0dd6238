/// Counter-based random numbers (Philox 4x64): each is a function of (seed, purpose, particle, draw) alone, so a bed is the
/// same on any machine, thread count and call order.
#pragma once
#include <cstdint>

namespace regolab::generate {

enum class Purpose : std::uint64_t { kDiameter = 1, kPosition = 2, kKind = 3, kAspect = 4, kRotation = 5, kWitness = 6 };

class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}
  /// Uniform in [0, 1), 53 bits.
  double uniform(Purpose purpose, std::uint64_t particle, std::uint64_t draw = 0) const;

 private:
  std::uint64_t seed_;
};

}  // namespace regolab::generate
