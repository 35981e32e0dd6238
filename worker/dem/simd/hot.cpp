#include "worker/dem/simd/hot.h"

#include <cstdlib>
#include <string_view>

namespace regolab::dem {
namespace {

bool has(Simd level) {
#if defined(__x86_64__)
  if (level == Simd::kAvx512) return __builtin_cpu_supports("x86-64-v4");
  if (level == Simd::kAvx2) return __builtin_cpu_supports("x86-64-v3");
#endif
  return level == Simd::kPortable;
}

Simd first_choice() {
  const char* named = std::getenv("REGOLAB_SIMD");
  const std::string_view wish = named ? named : "";
  if (wish == "portable") return Simd::kPortable;
  if (wish != "avx2" && has(Simd::kAvx512)) return Simd::kAvx512;
  return has(Simd::kAvx2) ? Simd::kAvx2 : Simd::kPortable;
}

Simd& level() {
  static Simd chosen = first_choice();
  return chosen;
}

}  // namespace

Simd simd() { return level(); }

bool set_simd(Simd wish) {
  if (!has(wish)) return false;
  level() = wish;
  return true;
}

}  // namespace regolab::dem
