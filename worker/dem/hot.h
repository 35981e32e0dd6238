/// Marks a hot loop: compiled for AVX2 and for any x86-64, chosen when the program starts. Contraction is off, so both give
/// the same bits.
#pragma once

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define REGOLAB_HOT __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define REGOLAB_HOT
#endif

/// Arithmetic that hot loops are made of.
#define REGOLAB_INLINE inline __attribute__((always_inline))
