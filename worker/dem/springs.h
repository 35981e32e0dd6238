/// The sliding history between list builds: the tangential springs of the touching contacts alone, in canonical order. What a
/// checkpoint holds, so that saved bytes do not depend on when or how lists were made.
#pragma once
#include <cstdint>
#include <vector>

namespace regolab::dem {

struct Springs {
  std::vector<std::int32_t> first, second;  // [n] sphere and sphere, or sphere and wall; sorted by first, then second
  std::vector<double> sx, sy, sz;           // [n] [m]
  std::vector<double> rx, ry, rz;           // [n] rolling angles, where contacts resist rolling; else empty

  void clear() {
    first.clear(), second.clear();
    sx.clear(), sy.clear(), sz.clear();
    rx.clear(), ry.clear(), rz.clear();
  }
  void push(std::int32_t a, std::int32_t b, double x, double y, double z) {
    first.push_back(a), second.push_back(b);
    sx.push_back(x), sy.push_back(y), sz.push_back(z);
  }
  std::size_t size() const { return first.size(); }

  template <class A>
  void archive(A& ar) { ar(first, second, sx, sy, sz); }
  template <class A>
  void archive_rolling(A& ar) { ar(rx, ry, rz); }
};

}  // namespace regolab::dem
