/// The most double additions and multiplications one core does per second: AVX2 vectors in registers, no memory. Prints
/// gflops=N, the best of several short rounds. The engine uses no fused operations, so neither does this.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

using Pack = double __attribute__((vector_size(32)));

/// Latency of 3 cycles times 2 a cycle, for multiplications and additions each; with two constants they fill 14 of 16
/// registers.
constexpr int kChains = 6;

/// Twice kChains packs of 4 a turn. Values stay near 1.
#if defined(__x86_64__)
__attribute__((target("avx2")))
#endif
double
spin(long turns) {
  Pack product[kChains], sum[kChains];
  for (int k = 0; k < kChains; ++k) product[k] = sum[k] = Pack{1, 1, 1, 1} * (1 + 0.01 * k);
  const Pack factor = Pack{1, 1, 1, 1} * (1 + 1e-15), term = Pack{1, 1, 1, 1} * 1e-15;
  for (long i = 0; i < turns; ++i) {
#pragma GCC unroll 6
    for (int k = 0; k < kChains; ++k) {
      product[k] *= factor;
      sum[k] += term;
    }
  }
  Pack all = product[0] + sum[0];
  for (int k = 1; k < kChains; ++k) all += product[k] + sum[k];
  return all[0] + all[1] + all[2] + all[3];
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main() {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) {
    std::fprintf(stderr, "bench_peak: no peak measured (this processor has no AVX2) use a newer x86-64\n");
    return 1;
  }
#endif
  constexpr long kTurns = 20'000'000;
  double best = 0, keep = 0;
  for (int round = 0; round < 7; ++round) {
    const double begun = cpu_seconds();
    keep += spin(kTurns);
    best = std::max(best, 4.0 * 2 * kChains * kTurns / (cpu_seconds() - begun) * 1e-9);
  }
  if (keep == 0) std::abort();  // the sums are used, so they are made
  std::printf("gflops=%.2f\n", best);
}
