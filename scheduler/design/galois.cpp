#include "scheduler/design/galois.h"

namespace regolab {
namespace {

struct FieldRow {
  int q, p, modulus;
};
// x is the modulus of a prime field: a "polynomial" of degree 1, so that residues are the constants.
constexpr FieldRow kFields[] = {
    {2, 2, 0b10},  {3, 3, 3}, {4, 2, 0b111},   // x^2 + x + 1
    {5, 5, 5},     {7, 7, 7}, {8, 2, 0b1011},  // x^3 + x + 1
    {9, 3, 9 + 1},                             // x^2 + 1
};

const FieldRow* find(int q) {
  for (const FieldRow& row : kFields) {
    if (row.q == q) return &row;
  }
  return nullptr;
}

}  // namespace

bool GaloisField::exists(int q) { return find(q) != nullptr; }

GaloisField::GaloisField(int q) : q_(q), p_(find(q)->p), modulus_(find(q)->modulus) {}

int GaloisField::add(int a, int b) const {
  int sum = 0;
  for (int place = 1; place < q_; place *= p_, a /= p_, b /= p_) sum += (a % p_ + b % p_) % p_ * place;
  return sum;
}

int GaloisField::multiply(int a, int b) const {
  // Horner: product = (...(b_n a) x + ...) x + b_0 a, reduced whenever x carries it to degree n.
  const auto scale = [&](int element, int digit) {
    int result = 0;
    for (int i = 0; i < digit; ++i) result = add(result, element);
    return result;
  };
  const auto times_x = [&](int element) {
    const int lead = element * p_ / q_;  // the digit that leaves the field
    const int shifted = element * p_ % q_;
    int reduction = modulus_ % q_;  // x^n = -(modulus - x^n)
    reduction = scale(reduction, (p_ - lead) % p_);
    return add(shifted, reduction);
  };
  int top = 1;
  while (top * p_ < q_) top *= p_;
  int product = 0;
  for (int place = top; place >= 1; place /= p_) {
    if (place != top) product = times_x(product);
    product = add(product, scale(a, b / place % p_));
  }
  return product;
}

}  // namespace regolab
