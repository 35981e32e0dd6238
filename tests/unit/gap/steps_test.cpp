/// Steps as bytes and back.
#include "scheduler/gap/steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

Posterior posterior() {
  Posterior p;
  p.log_z = -1.0 / 3, p.log_z_error = 1e-300;
  p.u = Eigen::MatrixXd::Random(3, 7);
  p.log_likelihood = Eigen::VectorXd::Random(7);
  p.log_likelihood[2] = -INFINITY;
  return p;
}

TEST(Steps, APosteriorComesBackBitForBit) {
  const Posterior p = posterior();
  const auto again = posterior_from(bytes_of(p));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->log_z, p.log_z);
  EXPECT_EQ(again->log_z_error, p.log_z_error);
  EXPECT_EQ(again->u, p.u);
  EXPECT_EQ(again->log_likelihood, p.log_likelihood);
}

TEST(Steps, WhereComesBackBitForBit) {
  const std::vector<GroupGap> where{{.group = {gap::Test::kStress, 1250, Part::kPeak}, .feature = "f", .text = "38 % low", .shift_pct = -38.1, .z = -4, .p = 0.1, .p_adjusted = 1.0 / 3},
                                    {.group = {}, .feature = "", .text = ""}};
  const auto again = where_from(bytes_of(where));
  ASSERT_TRUE(again);
  ASSERT_EQ(again->size(), 2U);
  EXPECT_EQ(again->front().group, where.front().group);
  EXPECT_EQ(again->front().text, "38 % low");
  EXPECT_EQ(again->front().p_adjusted, 1.0 / 3);
}

TEST(Steps, BytesThatAreNotOursAreNoStep) {
  const std::string good = bytes_of(posterior());
  EXPECT_FALSE(where_from(good));
  EXPECT_FALSE(posterior_from(bytes_of(std::vector<GroupGap>{})));
  for (const std::size_t cut : {std::size_t{0}, std::size_t{5}, good.size() / 2, good.size() - 1}) EXPECT_FALSE(posterior_from(good.substr(0, cut))) << cut;
  EXPECT_FALSE(posterior_from(good + "x"));
  std::string huge = good;
  huge.replace(8 + 11 + 16, 8, std::string(8, '\x7f'));  // the number of rows
  EXPECT_FALSE(posterior_from(huge));
}

TEST(Steps, WhatWasFoundBeforeIsNotMadeAgain) {
  std::map<std::string, std::string> kept;
  const StepMemory memory{.find = [&](const std::string& name) { return kept.contains(name) ? std::optional(kept[name]) : std::nullopt; },
                          .keep = [&](const std::string& name, const std::string& bytes) { kept[name] = bytes; }};
  int made = 0;
  const auto make = [&] { return ++made, posterior(); };
  const Posterior first = remembered_posterior(&memory, "a", make), again = remembered_posterior(&memory, "a", make);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(first.u, again.u);
  kept["a"] = "damaged";
  remembered_posterior(&memory, "a", make);
  EXPECT_EQ(made, 2) << "made anew rather than trusted";
  remembered_posterior(nullptr, "a", make);
  EXPECT_EQ(made, 3);
}

}  // namespace
}  // namespace regolab::gap
