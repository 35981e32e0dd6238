/// Finite fields of 2, 3, 4, 5, 7, 8 and 9 elements: what orthogonal arrays are built from.
#pragma once

namespace regolab {

/// Elements are 0 .. q - 1; an element's digits in base p are the coefficients of its polynomial, lowest first.
class GaloisField {
 public:
  /// REQUIRES: exists(q).
  explicit GaloisField(int q);

  static bool exists(int q);

  int size() const { return q_; }
  int add(int a, int b) const;
  int multiply(int a, int b) const;

 private:
  int q_;
  int p_;        ///< prime below: q = p^n
  int modulus_;  ///< the irreducible polynomial, digits in base p, degree n
};

}  // namespace regolab
