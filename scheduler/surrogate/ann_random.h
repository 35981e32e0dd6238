/// Random numbers for training: functions of (seed, purpose, index, draw) alone, so a split and a random start are the same on any
/// machine and in any order of calls.
#pragma once
#include "scheduler/random/philox.h"

namespace regolab::surrogate {

enum class AnnPurpose : std::uint64_t { kSplit = 1, kStart = 2 };

/// Uniform in [0, 1), 53 bits.
inline double ann_uniform(std::uint64_t seed, AnnPurpose purpose, std::uint64_t index, std::uint64_t draw = 0) {
  return Philox(seed, static_cast<std::uint64_t>(purpose)).uniform53(index, draw);
}

}  // namespace regolab::surrogate
