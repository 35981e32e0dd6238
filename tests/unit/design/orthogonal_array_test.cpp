#include "scheduler/design/orthogonal_array.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "scheduler/design/array_quality.h"

namespace regolab {
namespace {

std::map<std::string, const OrthogonalArray*> by_name() {
  std::map<std::string, const OrthogonalArray*> arrays;
  for (const OrthogonalArray& array : built_in_arrays()) arrays[array.name] = &array;
  return arrays;
}

TEST(OrthogonalArrays, HoldAllThatArePromised) {
  const auto arrays = by_name();
  EXPECT_EQ(arrays.size(), built_in_arrays().size());
  for (const char* name : {"L4 (2^3)", "L8 (2^7)", "L9 (3^4)", "L12 (2^11)", "L16 (2^15)", "L16 (4^5)", "L18 (2^1 3^7)",
                           "L25 (5^6)", "L27 (3^13)", "L32 (4^9 2^1)", "L32 (2^31)", "L64 (4^21)", "L64 (2^63)"}) {
    EXPECT_TRUE(arrays.contains(name)) << name;
  }
}

/// Pair counts by hand, not by quality_of: every pair of columns holds every pair of levels equally often.
TEST(OrthogonalArrays, HaveStrengthTwo) {
  for (const OrthogonalArray& array : built_in_arrays()) {
    for (std::size_t a = 0; a < array.levels.size(); ++a) {
      for (std::size_t b = a + 1; b < array.levels.size(); ++b) {
        std::map<std::pair<int, int>, int> count;
        for (const auto& row : array.rows) ++count[{row[a], row[b]}];
        ASSERT_EQ(count.size(), static_cast<std::size_t>(array.levels[a] * array.levels[b]))
            << array.name << " columns " << a << ", " << b;
        for (const auto& [pair, n] : count) {
          ASSERT_EQ(n, static_cast<int>(array.rows.size()) / (array.levels[a] * array.levels[b])) << array.name;
          ASSERT_TRUE(pair.first >= 0 && pair.first < array.levels[a]) << array.name;
        }
      }
    }
    EXPECT_GE(quality_of(array.levels, array.rows).strength, 2) << array.name;
    EXPECT_TRUE(quality_of(array.levels, array.rows).balanced) << array.name;
  }
}

TEST(OrthogonalArrays, RepeatNoRow) {
  for (const OrthogonalArray& array : built_in_arrays()) {
    const std::set<std::vector<int>> rows(array.rows.begin(), array.rows.end());
    EXPECT_EQ(rows.size(), array.rows.size()) << array.name;
  }
}

TEST(OrthogonalArrays, KeepTheErrorDegreesOfFreedomOfTheBooks) {
  const auto arrays = by_name();
  const std::map<std::string, int> expected{
      {"L4 (2^3)", 0}, {"L12 (2^11)", 0}, {"L18 (2^1 3^7)", 2}, {"L27 (3^13)", 0}, {"L32 (4^9 2^1)", 3}};
  for (const auto& [name, df] : expected) {
    EXPECT_EQ(quality_of(arrays.at(name)->levels, arrays.at(name)->rows).error_degrees_of_freedom, df) << name;
  }
}

TEST(OrthogonalArrays, FewTwoLevelFactorsGetStrengthThree) {  // odd-weight columns first
  const OrthogonalArray& l16 = *by_name().at("L16 (2^15)");
  std::vector<std::vector<int>> rows;
  for (const auto& row : l16.rows) rows.emplace_back(row.begin(), row.begin() + 8);
  EXPECT_EQ(quality_of(std::vector<int>(8, 2), rows).strength, 3);
}

TEST(FullFactorial, HoldsEveryCombinationOnce) {
  const int levels[] = {2, 3, 4};
  const OrthogonalArray full = full_factorial(levels);
  EXPECT_EQ(full.rows.size(), 24u);
  EXPECT_EQ(std::set(full.rows.begin(), full.rows.end()).size(), 24u);
  EXPECT_EQ(full.rows.front(), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(full.rows[1], (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(quality_of(levels, full.rows).strength, 3);
  EXPECT_EQ(full.name, "full factorial (2^1 3^1 4^1)");
}

TEST(ArrayQuality, SeesOneWrongCell) {
  OrthogonalArray l9 = *by_name().at("L9 (3^4)");
  EXPECT_EQ(unbalanced_pair(l9.levels, l9.rows), std::nullopt);
  l9.rows[4][2] = (l9.rows[4][2] + 1) % 3;
  const ArrayQuality quality = quality_of(l9.levels, l9.rows);
  EXPECT_EQ(quality.strength, 0);
  EXPECT_FALSE(quality.balanced);
  EXPECT_EQ(unbalanced_pair(l9.levels, l9.rows), (std::pair<std::size_t, std::size_t>(0, 2)));
}

TEST(ArrayQuality, BalancedIsLessThanOrthogonal) {
  const std::vector<std::vector<int>> rows{{0, 0}, {0, 0}, {1, 1}, {1, 1}};
  const int levels[] = {2, 2};
  EXPECT_EQ(quality_of(levels, rows).strength, 1);
  EXPECT_TRUE(quality_of(levels, rows).balanced);
}

}  // namespace
}  // namespace regolab
