#include "scheduler/design/galois.h"

#include <gtest/gtest.h>

#include <set>

namespace regolab {
namespace {

class Fields : public ::testing::TestWithParam<int> {};

TEST_P(Fields, ObeyTheAxioms) {
  const int q = GetParam();
  const GaloisField f(q);
  for (int a = 0; a < q; ++a) {
    EXPECT_EQ(f.add(a, 0), a);
    EXPECT_EQ(f.multiply(a, 1), a);
    EXPECT_EQ(f.multiply(a, 0), 0);
    std::set<int> sums, products;
    for (int b = 0; b < q; ++b) {
      EXPECT_EQ(f.add(a, b), f.add(b, a));
      EXPECT_EQ(f.multiply(a, b), f.multiply(b, a));
      sums.insert(f.add(a, b));
      products.insert(f.multiply(a, b));
      for (int c = 0; c < q; ++c) {
        EXPECT_EQ(f.multiply(a, f.add(b, c)), f.add(f.multiply(a, b), f.multiply(a, c)));
        EXPECT_EQ(f.multiply(a, f.multiply(b, c)), f.multiply(f.multiply(a, b), c));
      }
    }
    EXPECT_EQ(sums.size(), static_cast<std::size_t>(q));                    // subtraction exists
    EXPECT_EQ(products.size(), a == 0 ? 1u : static_cast<std::size_t>(q));  // and division
  }
}

INSTANTIATE_TEST_SUITE_P(AllSizes, Fields, ::testing::Values(2, 3, 4, 5, 7, 8, 9));

TEST(GaloisField, ExistsOnlyWhereBuilt) {
  EXPECT_TRUE(GaloisField::exists(8));
  EXPECT_FALSE(GaloisField::exists(6));
  EXPECT_FALSE(GaloisField::exists(1));
}

}  // namespace
}  // namespace regolab
