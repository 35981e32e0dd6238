/// Records of four doubles, one for each lane, to and from packs.
#pragma once
#include <type_traits>

#include "worker/dem/simd/pack.h"

namespace regolab::dem {

/// First three fields of the records, and the fourth.
template <class Pack>
struct Gathered {
  Triple<Pack> xyz;
  Pack fourth;
};

template <class Address>
REGOLAB_INLINE void gather(Address address_of, Gathered<Four>& out) {
  const Four a = load<Four>(address_of(0)), b = load<Four>(address_of(1)), c = load<Four>(address_of(2)), d = load<Four>(address_of(3));
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  out.xyz = {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
             __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7)};
  out.fourth = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Two records side by side.
REGOLAB_INLINE Eight side_by_side(const double* low, const double* high) {
  return __builtin_shufflevector(load<Four>(low), load<Four>(high), 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Rows 0 and 2 share a register, so do 1 and 3: then whole 128-bit quarters fall into place and no lane crosses.
template <class Address>
REGOLAB_INLINE void gather(Address address_of, Gathered<Eight>& out) {
  const Eight a = side_by_side(address_of(0), address_of(2)), b = side_by_side(address_of(1), address_of(3));
  const Eight c = side_by_side(address_of(4), address_of(6)), d = side_by_side(address_of(5), address_of(7));
  const Eight ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const Eight cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  out.xyz = {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5, 8, 9, 12, 13),
             __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5, 8, 9, 12, 13),
             __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7, 10, 11, 14, 15)};
  out.fourth = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7, 10, 11, 14, 15);
}

template <class Pack, class Address>
REGOLAB_INLINE Gathered<Pack> gathered(Address address_of) {
  Gathered<Pack> out;
  gather(address_of, out);
  return out;
}

/// The records of all lanes, their fourth field zero. Named, not an array: arrays of registers would go through memory.
template <class Pack>
struct Rows;
template <>
struct Rows<Four> {
  Four a, b, c, d;
};
template <>
struct Rows<Eight> {
  Rows<Four> low, high;
};

REGOLAB_INLINE Rows<Four> rows_of(const Triple<Four>& v) {
  const Four zero{};
  const Four xy_even = __builtin_shufflevector(v.x, v.y, 0, 4, 2, 6), xy_odd = __builtin_shufflevector(v.x, v.y, 1, 5, 3, 7);
  const Four z_even = __builtin_shufflevector(v.z, zero, 0, 4, 2, 6), z_odd = __builtin_shufflevector(v.z, zero, 1, 5, 3, 7);
  return {__builtin_shufflevector(xy_even, z_even, 0, 1, 4, 5), __builtin_shufflevector(xy_odd, z_odd, 0, 1, 4, 5),
          __builtin_shufflevector(xy_even, z_even, 2, 3, 6, 7), __builtin_shufflevector(xy_odd, z_odd, 2, 3, 6, 7)};
}
REGOLAB_INLINE Four low_half(const Eight& v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); }
REGOLAB_INLINE Four high_half(const Eight& v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); }
REGOLAB_INLINE Rows<Eight> rows_of(const Triple<Eight>& v) {
  return {rows_of(Triple<Four>{low_half(v.x), low_half(v.y), low_half(v.z)}),
          rows_of(Triple<Four>{high_half(v.x), high_half(v.y), high_half(v.z)})};
}

/// visit(lane, record of each of `rows`...) for the first `lanes` lanes, in order.
template <class Visit, class... R>
  requires(std::is_same_v<R, Rows<Four>> && ...)
REGOLAB_INLINE void each_row(int from, int lanes, Visit visit, const R&... rows) {
  visit(from, rows.a...);
  if (lanes > 1) visit(from + 1, rows.b...);
  if (lanes > 2) visit(from + 2, rows.c...);
  if (lanes > 3) visit(from + 3, rows.d...);
}
template <class Visit, class... R>
  requires(std::is_same_v<R, Rows<Eight>> && ...)
REGOLAB_INLINE void each_row(int from, int lanes, Visit visit, const R&... rows) {
  each_row(from, lanes, visit, rows.low...);
  if (lanes > 4) each_row(from + 4, lanes - 4, visit, rows.high...);
}

}  // namespace regolab::dem
