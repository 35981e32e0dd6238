/// Every width of the hot loops that this processor has.
#pragma once
#include <vector>

#include "worker/dem/simd/hot.h"

namespace regolab::test {

/// Puts the choice back when it goes.
class KeepSimd {
 public:
  KeepSimd() = default;
  ~KeepSimd() { dem::set_simd(before_); }
  KeepSimd(const KeepSimd&) = delete;
  KeepSimd& operator=(const KeepSimd&) = delete;

 private:
  dem::Simd before_ = dem::simd();
};

inline std::vector<dem::Simd> simd_levels() {
  const KeepSimd keep;
  std::vector<dem::Simd> levels;
  for (const auto level : {dem::Simd::kPortable, dem::Simd::kAvx2, dem::Simd::kAvx512}) {
    if (dem::set_simd(level)) levels.push_back(level);
  }
  return levels;
}

inline const char* name_of(dem::Simd level) {
  return level == dem::Simd::kPortable ? "portable" : level == dem::Simd::kAvx2 ? "avx2" : "avx512";
}

}  // namespace regolab::test
