/// Counter-based random numbers, Philox 4x64 [Salmon et al. 2011, doi 10.1145/2063384.2063405]: each is a function of (seed, stream, counter)
/// alone, so a draw is the same on any machine and in any order of calls.
#pragma once
#include <Random123/boxmuller.hpp>
#include <Random123/philox.h>
#include <Random123/uniform.hpp>
#include <cstdint>

namespace regolab {

class Philox {
 public:
  Philox(std::uint64_t seed, std::uint64_t stream) : key_{{seed, stream}} {}

  /// In (0, 1).
  double uniform(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) const { return r123::u01fixedpt<double>(words(a, b, c)[0]); }
  /// In [0, 1), 53 bits.
  double uniform53(std::uint64_t a, std::uint64_t b = 0) const { return static_cast<double>(words(a, b, 0)[0] >> 11) * 0x1.0p-53; }
  /// Standard normal.
  double normal(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) const {
    const auto w = words(a, b, c);
    return r123::boxmuller(w[0], w[1]).x;
  }

 private:
  r123::Philox4x64::ctr_type words(std::uint64_t a, std::uint64_t b, std::uint64_t c) const { return r123::Philox4x64{}({{a, b, c, 0}}, key_); }
  r123::Philox4x64::key_type key_;
};

}  // namespace regolab
