#include "scheduler/gap/gp_block.h"

#include <bit>
#include <cmath>
#include <cstdint>

// One loop, compiled for each width of registers; the best of this processor is called.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define REGOLAB_EVERY_WIDTH __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define REGOLAB_EVERY_WIDTH
#endif

namespace regolab::gap {
namespace {

using Eigen::Index;

constexpr Index kLanes = 8;  // points that are computed together
using Lanes [[gnu::vector_size(kLanes * sizeof(double)), gnu::aligned(sizeof(double)), gnu::may_alias]] = double;
using Bits [[gnu::vector_size(kLanes * sizeof(double))]] = std::uint64_t;
constexpr double kRoot5 = 2.23606797749978969;

/// e^-t for t from 0 to 700, to 1e-14 of itself: 2^-n e^f with |f| <= ln 2 / 2.
[[gnu::always_inline]] inline void exp_minus(const Lanes& t, Lanes& out) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: a number added to it is rounded, and stands in its lowest bits
  constexpr double kLog2High = 0x1.62e42fefa38p-1, kLog2Low = 0x1.ef35793c7673p-45;
  constexpr double kTerms[] = {1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1, 1};
  const Lanes shifted = t * 1.44269504088896341 + kRound, n = shifted - kRound, f = (n * kLog2High - t) + n * kLog2Low;
  Lanes sum = f * 0 + 1.0 / 479001600;
#pragma GCC unroll 12
  for (const double term : kTerms) sum = sum * f + term;
  const Bits power = (1023 + 0x4338000000000000ULL - std::bit_cast<Bits>(shifted)) << 52;
  out = sum * std::bit_cast<Lanes>(power);
}

REGOLAB_EVERY_WIDTH void multiply_rows(const double* a, const double* b, double* c, Index k, Index m) {
  for (Index i = 0; i < m; i += kTile) {
    for (Index j = 0; j < kBlock; j += kLanes) {
      Lanes s0{}, s1{}, s2{}, s3{};
      for (Index r = 0; r < k; ++r) {
        const double* left = a + r * m + i;
        const Lanes right = *reinterpret_cast<const Lanes*>(b + r * kBlock + j);
        s0 += left[0] * right, s1 += left[1] * right, s2 += left[2] * right, s3 += left[3] * right;
      }
      double* to = c + i * kBlock + j;
      for (const Lanes& s : {s0, s1, s2, s3}) *reinterpret_cast<Lanes*>(to) = s, to += kBlock;
    }
  }
}

REGOLAB_EVERY_WIDTH void matern_rows(const double* run, const double* point, double* c, Index n, Index d) {
  for (Index r = 0; r < n; ++r) {
    double far[kBlock] = {};
    for (Index k = 0; k < d; ++k) {
      for (Index q = 0; q < kBlock; ++q) {
        const double off = point[k * kBlock + q] - run[r * d + k];
        far[q] += off * off;
      }
    }
    for (double& q : far) q = kRoot5 * std::sqrt(q);
    for (double& q : far) q = q < 700 ? q : 700;
    for (Index q = 0; q < kBlock; q += kLanes) {
      const Lanes t = *reinterpret_cast<const Lanes*>(far + q);
      Lanes fall;
      exp_minus(t, fall);
      *reinterpret_cast<Lanes*>(c + r * kBlock + q) += (1 + t + t * t / 3) * fall;
    }
  }
}

}  // namespace

Rows padded(const Eigen::MatrixXd& m) {
  Rows out = Rows::Zero(m.rows(), (m.cols() + kTile - 1) / kTile * kTile);
  out.leftCols(m.cols()) = m;
  return out;
}

void multiply(const Rows& a, const Rows& b, Rows& c) {
  c.resize(a.cols(), kBlock);
  multiply_rows(a.data(), b.data(), c.data(), a.rows(), a.cols());
}

void add_matern(const Rows& run, const Rows& point, Rows& c) { matern_rows(run.data(), point.data(), c.data(), run.rows(), run.cols()); }

}  // namespace regolab::gap
