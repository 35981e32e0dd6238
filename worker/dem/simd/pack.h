/// Doubles that go through the arithmetic together: GCC's vector extension, four or eight wide. The laws are templates over the
/// number: `double` is their plain path.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>

#include "worker/dem/simd/hot.h"

namespace regolab::dem {

using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

template <class Pack>
inline constexpr int kLanes = static_cast<int>(sizeof(Pack) / sizeof(double));
inline constexpr int kMostLanes = kLanes<Eight>;

template <class Pack>
REGOLAB_INLINE Pack pack_of(double v) { return Pack{} + v; }

REGOLAB_INLINE double select(bool which, double yes, double no) { return which ? yes : no; }
template <class Mask, class Pack>
REGOLAB_INLINE Pack select(const Mask& which, const Pack& yes, const Pack& no) { return which ? yes : no; }

REGOLAB_INLINE double root(double v) { return std::sqrt(v); }
template <class Pack>
REGOLAB_INLINE Pack root(const Pack& v) {
  Pack r;
  for (int l = 0; l < kLanes<Pack>; ++l) r[l] = __builtin_sqrt(v[l]);  // one instruction
  return r;
}

using FourMask = std::int64_t __attribute__((vector_size(32)));
using EightMask = std::int64_t __attribute__((vector_size(64)));
REGOLAB_INLINE bool any(const FourMask& m) { return ((m[0] | m[1]) | (m[2] | m[3])) != 0; }
REGOLAB_INLINE bool any(const EightMask& m) {
  return any(__builtin_shufflevector(m, m, 0, 1, 2, 3) | __builtin_shufflevector(m, m, 4, 5, 6, 7));
}

template <class Pack>
REGOLAB_INLINE Pack load(const double* from) {
  Pack v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class Pack>
REGOLAB_INLINE void store(const Pack& v, double* to) { std::memcpy(to, &v, sizeof v); }

/// The first `lanes` entries; the rest zero, or left alone. With all lanes these are one instruction.
template <class Pack>
REGOLAB_INLINE Pack load_lanes(const double* from, int lanes) {
  if (lanes == kLanes<Pack>) return load<Pack>(from);
  Pack v{};
  for (int l = 0; l < lanes; ++l) v[l] = from[l];
  return v;
}
template <class Pack>
REGOLAB_INLINE void store_lanes(const Pack& v, double* to, int lanes) {
  if (lanes == kLanes<Pack>) return store(v, to);
  for (int l = 0; l < lanes; ++l) to[l] = v[l];
}

template <class Pack>
struct Triple {
  Pack x, y, z;
};
template <class Pack>
REGOLAB_INLINE Pack dot(const Triple<Pack>& a, const Triple<Pack>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class Pack>
REGOLAB_INLINE Triple<Pack> cross(const Triple<Pack>& a, const Triple<Pack>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Pack>
REGOLAB_INLINE Triple<Pack> operator+(const Triple<Pack>& a, const Triple<Pack>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class Pack>
REGOLAB_INLINE Triple<Pack> operator-(const Triple<Pack>& a, const Triple<Pack>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class Pack>
REGOLAB_INLINE Triple<Pack> operator*(const Pack& s, const Triple<Pack>& v) { return {s * v.x, s * v.y, s * v.z}; }
template <class Pack>
REGOLAB_INLINE Triple<Pack> operator*(double s, const Triple<Pack>& v) { return {s * v.x, s * v.y, s * v.z}; }

}  // namespace regolab::dem
