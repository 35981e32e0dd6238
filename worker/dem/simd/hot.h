/// Hot loops are written once, as templates over a pack of doubles, and compiled for AVX-512, for AVX2 and for any x86-64. The program
/// takes the best that the processor has. Contraction is off and the order of sums is fixed, so all three give the same bits.
#pragma once

namespace regolab::dem {

enum class Simd { kPortable, kAvx2, kAvx512 };

/// What runs: the best of this processor, or what REGOLAB_SIMD (portable, avx2, avx512) names if the processor has it.
Simd simd();
/// For tests: takes another; false when this processor does not have it.
bool set_simd(Simd level);

}  // namespace regolab::dem

/// Arithmetic that hot loops are made of.
#define REGOLAB_INLINE inline __attribute__((always_inline))
#define REGOLAB_INLINE_LAMBDA __attribute__((always_inline))

/// Defines `name parameters` from the template `name##_with<Pack>`. GCC lowers packs of four to what the target has.
#if defined(__x86_64__)
#define REGOLAB_HOT(type, name, parameters, arguments)                                                                      \
  namespace {                                                                                                               \
  __attribute__((target("arch=x86-64-v4"))) type name##_avx512 parameters { return name##_with<Eight> arguments; }          \
  __attribute__((target("arch=x86-64-v3"))) type name##_avx2 parameters { return name##_with<Four> arguments; }             \
  type name##_portable parameters { return name##_with<Four> arguments; }                                                   \
  }                                                                                                                         \
  type name parameters {                                                                                                    \
    switch (simd()) {                                                                                                       \
      case Simd::kAvx512: return name##_avx512 arguments;                                                                   \
      case Simd::kAvx2: return name##_avx2 arguments;                                                                       \
      case Simd::kPortable: break;                                                                                          \
    }                                                                                                                       \
    return name##_portable arguments;                                                                                       \
  }
#else
#define REGOLAB_HOT(type, name, parameters, arguments) \
  type name parameters { return name##_with<Four> arguments; }
#endif
