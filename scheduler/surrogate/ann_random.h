/// Counter-based random numbers for training (Philox 4x64): each is a function of (seed, purpose, index, draw) alone, so a
/// split and a random start are the same on any machine and in any order of calls.
#pragma once
#include <Random123/philox.h>

#include <cstdint>

namespace regolab::surrogate {

enum class AnnPurpose : std::uint64_t { kSplit = 1, kStart = 2 };

/// Uniform in [0, 1), 53 bits.
inline double ann_uniform(std::uint64_t seed, AnnPurpose purpose, std::uint64_t index, std::uint64_t draw = 0) {
  const r123::Philox4x64::ctr_type counter = {{index, draw, 0, 0}};
  const r123::Philox4x64::key_type key = {{seed, static_cast<std::uint64_t>(purpose)}};
  return static_cast<double>(r123::Philox4x64{}(counter, key)[0] >> 11) * 0x1.0p-53;
}

}  // namespace regolab::surrogate
