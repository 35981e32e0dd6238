#include "scheduler/design/orthogonal_array.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "scheduler/design/galois.h"

namespace regolab {
namespace {

int power(int base, int exponent) {
  int value = 1;
  for (int i = 0; i < exponent; ++i) value *= base;
  return value;
}

OrthogonalArray named(OrthogonalArray array) {
  std::ranges::sort(array.rows);
  array.name = "L" + std::to_string(array.rows.size()) + " (" + level_formula(array.levels) + ")";
  return array;
}

/// The points of the projective space over GF(q): vectors of length k whose first non-zero digit is 1, as base-q numbers.
/// Unit vectors come first, so that few factors get a full factorial; over GF(2) all odd-weight vectors come before the even
/// ones, because any three of those are independent (strength 3).
std::vector<int> projective_points(int q, int k) {
  std::vector<int> points;
  for (int v = 1; v < power(q, k); ++v) {
    int lead = v;
    while (lead >= q) lead /= q;
    if (lead == 1) points.push_back(v);
  }
  const auto weight = [&](int v) {
    int nonzero = 0;
    for (; v > 0; v /= q) nonzero += v % q != 0 ? 1 : 0;
    return nonzero;
  };
  const auto order = [&](int v) { return std::pair((q == 2 && weight(v) % 2 == 0) ? 1 : 0, weight(v)); };
  std::ranges::stable_sort(points, {}, order);
  return points;
}

/// Linear array: q^k rows are all vectors of GF(q)^k, each column the inner product with one projective point.
OrthogonalArray linear(int q, int k) {
  const GaloisField field(q);
  const std::vector<int> points = projective_points(q, k);
  OrthogonalArray array{.name = {}, .levels = std::vector<int>(points.size(), q), .rows = {}};
  for (int vector = 0; vector < power(q, k); ++vector) {
    std::vector<int> row;
    for (const int point : points) {
      int sum = 0;
      for (int i = 0, a = vector, b = point; i < k; ++i, a /= q, b /= q) sum = field.add(sum, field.multiply(a % q, b % q));
      row.push_back(sum);
    }
    array.rows.push_back(std::move(row));
  }
  return named(std::move(array));
}

/// Rows (i, g): an n-level column i beside columns D[i][j] + g of a difference scheme D(n, columns, q); `split` gives i as
/// the columns it is to be shown as, e.g. {4, 2} for an 8-level i.
OrthogonalArray from_difference_scheme(const std::vector<std::vector<int>>& scheme, const GaloisField& field,
                                       const std::vector<int>& split, bool split_first) {
  OrthogonalArray array;
  const int n = static_cast<int>(scheme.size());
  const std::vector<int> developed(scheme.front().size(), field.size());
  array.levels = split_first ? split : developed;
  const std::vector<int>& second = split_first ? developed : split;
  array.levels.insert(array.levels.end(), second.begin(), second.end());
  for (int i = 0; i < n; ++i) {
    std::vector<int> parts;
    for (int rest = i; const int levels : split) {
      parts.push_back(rest % levels);
      rest /= levels;
    }
    for (int g = 0; g < field.size(); ++g) {
      std::vector<int> row = split_first ? parts : std::vector<int>{};
      for (const int d : scheme[static_cast<std::size_t>(i)]) row.push_back(field.add(d, g));
      if (!split_first) row.insert(row.end(), parts.begin(), parts.end());
      array.rows.push_back(std::move(row));
    }
  }
  return named(std::move(array));
}

/// D(8, 8, 4): the multiplication table of GF(8), mapped onto GF(4)'s addition by dropping one binary digit.
std::vector<std::vector<int>> difference_scheme_8_4() {
  const GaloisField field(8);
  std::vector<std::vector<int>> scheme(8, std::vector<int>(8));
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) scheme[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = field.multiply(i, j) % 4;
  }
  return scheme;
}

/// D(6, 6, 3) [Hedayat et al., Table 6.20 up to order]: no field has 6 elements, so this one is a table.
std::vector<std::vector<int>> difference_scheme_6_3() {
  return {{0, 0, 0, 0, 0, 0}, {0, 1, 2, 1, 2, 0}, {0, 2, 1, 1, 0, 2},
          {0, 2, 2, 0, 1, 1}, {0, 0, 1, 2, 2, 1}, {0, 1, 0, 2, 1, 2}};
}

/// Plackett and Burman's 12 runs: the quadratic residues modulo 11 shifted round, and a row of zeros (Paley).
OrthogonalArray plackett_burman_12() {
  OrthogonalArray array{.name = {}, .levels = std::vector<int>(11, 2), .rows = {std::vector<int>(11, 0)}};
  std::vector<int> residues(11, 0);
  for (int i = 0; i < 11; ++i) residues[static_cast<std::size_t>(i * i % 11)] = 1;
  for (std::size_t shift = 0; shift < 11; ++shift) {
    std::vector<int> row(11);
    for (std::size_t j = 0; j < 11; ++j) row[j] = residues[(j + 11 - shift) % 11];
    array.rows.push_back(std::move(row));
  }
  return named(std::move(array));
}

/// Joins columns of the linear 2-level array with 2^k rows: `flats` disjoint subspaces of `dimension` (spread elements) each
/// become one column of 2^dimension levels; the columns left over stay.
OrthogonalArray joined(int k, int dimension, int flats) {
  const GaloisField big(power(2, dimension));
  // The spread comes from GF(2^dimension)^2: the lines through 0 are disjoint subspaces. REQUIRES: k == 2 * dimension, or
  // one flat.
  OrthogonalArray array;
  std::vector<std::vector<int>> bases;  // [flats][dimension] vectors of GF(2)^k
  for (int slope = 0; slope < flats; ++slope) {
    std::vector<int> basis;
    for (int digit = 0; digit < dimension; ++digit) {
      const int x = 1 << digit;
      basis.push_back(k == 2 * dimension ? x | big.multiply(slope, x) << dimension : x);
    }
    bases.push_back(std::move(basis));
  }
  std::vector<bool> used(static_cast<std::size_t>(power(2, k)), false);
  for (const auto& basis : bases) {
    for (int subset = 1; subset < power(2, dimension); ++subset) {
      int sum = 0;
      for (int digit = 0; digit < dimension; ++digit)
        sum ^= (subset >> digit & 1) != 0 ? basis[static_cast<std::size_t>(digit)] : 0;
      used[static_cast<std::size_t>(sum)] = true;
    }
    array.levels.push_back(power(2, dimension));
  }
  std::vector<int> left;
  for (const int point : projective_points(2, k)) {
    if (!used[static_cast<std::size_t>(point)]) left.push_back(point);
  }
  array.levels.insert(array.levels.end(), left.size(), 2);
  const auto parity = [](int a, int b) { return std::popcount(static_cast<unsigned>(a & b)) % 2; };
  for (int vector = 0; vector < power(2, k); ++vector) {
    std::vector<int> row;
    for (const auto& basis : bases) {
      int level = 0;
      for (int digit = 0; digit < dimension; ++digit)
        level |= parity(vector, basis[static_cast<std::size_t>(digit)]) << digit;
      row.push_back(level);
    }
    for (const int point : left) row.push_back(parity(vector, point));
    array.rows.push_back(std::move(row));
  }
  return named(std::move(array));
}

std::vector<OrthogonalArray> build_all() {
  const GaloisField three(3);
  const GaloisField four(4);
  std::vector<OrthogonalArray> arrays;
  arrays.push_back(linear(2, 2));
  arrays.push_back(linear(2, 3));
  arrays.push_back(joined(3, 2, 1));
  arrays.push_back(linear(3, 2));
  arrays.push_back(plackett_burman_12());
  arrays.push_back(linear(2, 4));
  for (int flats = 1; flats <= 4; ++flats) arrays.push_back(joined(4, 2, flats));
  arrays.push_back(linear(4, 2));
  arrays.push_back(joined(4, 3, 1));
  arrays.push_back(from_difference_scheme(difference_scheme_6_3(), three, {2, 3}, true));
  arrays.push_back(from_difference_scheme(difference_scheme_6_3(), three, {6}, true));
  arrays.push_back(linear(5, 2));
  arrays.push_back(linear(3, 3));
  arrays.push_back(linear(2, 5));
  arrays.push_back(from_difference_scheme(difference_scheme_8_4(), four, {4, 2}, false));
  arrays.push_back(from_difference_scheme(difference_scheme_8_4(), four, {8}, true));
  arrays.push_back(linear(7, 2));
  arrays.push_back(linear(2, 6));
  arrays.push_back(linear(4, 3));
  arrays.push_back(linear(8, 2));
  arrays.push_back(linear(3, 4));
  arrays.push_back(linear(9, 2));
  return arrays;
}

}  // namespace

std::span<const OrthogonalArray> built_in_arrays() {
  static const std::vector<OrthogonalArray> arrays = build_all();
  return arrays;
}

std::string level_formula(std::span<const int> levels) {
  std::string text;
  for (std::size_t i = 0; i < levels.size();) {
    std::size_t same = i;
    while (same < levels.size() && levels[same] == levels[i]) ++same;
    text += (text.empty() ? "" : " ") + std::to_string(levels[i]) + "^" + std::to_string(same - i);
    i = same;
  }
  return text;
}

OrthogonalArray full_factorial(std::span<const int> levels) {
  OrthogonalArray array{
      .name = "full factorial (" + level_formula(levels) + ")", .levels = {levels.begin(), levels.end()}, .rows = {}};
  std::vector<int> row(levels.size(), 0);
  while (true) {
    array.rows.push_back(row);
    std::size_t i = levels.size();
    while (i > 0 && ++row[i - 1] == levels[i - 1]) row[--i] = 0;  // an odometer
    if (i == 0) return array;
  }
}

}  // namespace regolab
