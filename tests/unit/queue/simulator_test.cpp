#include <gtest/gtest.h>

#include "virtual_lab.h"

namespace regolab::test {
namespace {

constexpr Faults kNone{};

void run_to_rest(VirtualLab& lab) {
  for (int i = 0; i < 200 && !lab.quiet(); ++i) lab.run(lab.now + 1000, kNone);
  lab.check_end();
}

TEST(Simulator, AQuietLabMeasuresEverythingOnce) {
  VirtualLab lab{1, 8};
  lab.submit(study(6));
  run_to_rest(lab);
  EXPECT_EQ(lab.refused, 0);
}

class SimulatedFaults : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SimulatedFaults, LoseNothingAndDoubleNothing) {
  VirtualLab lab{GetParam(), 12};
  const Faults bad{.lose = 0.1,
                   .twice = 0.1,
                   .slowest = 80,
                   .worker_crash = 2e-4,
                   .worker_pause = 1e-4,
                   .scheduler_crash = 0.004,
                   .commit_fails = 0.002,
                   .bed_loss = 0.002,
                   .transient = 0.02};
  lab.submit(study(8, 1 + GetParam() % 40));
  lab.run(1500, bad);
  lab.submit(study(8, 5 + GetParam() % 40));  // shares beds with the first
  lab.run(3000, bad);
  lab.submit(study(3, 1000));
  lab.run(3500, bad);
  lab.cancel_last();
  lab.run(6000, bad);
  run_to_rest(lab);
  EXPECT_GT(lab.restarts, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SimulatedFaults, testing::Range<std::uint64_t>(1, 41));

TEST(Simulator, ReplaysFromItsSeed) {
  const Faults bad{.lose = 0.1, .twice = 0.1, .slowest = 50, .worker_crash = 1e-3, .scheduler_crash = 0.01};
  std::vector<std::uint64_t> tokens;
  for (int i = 0; i < 2; ++i) {
    VirtualLab lab{77, 5};
    lab.submit(study(4));
    lab.run(4000, bad);
    for (const auto& [token, attempt] : lab.tables.attempts) {
      tokens.push_back(static_cast<std::uint64_t>(attempt.job) * 100 + attempt.outcome.size());
    }
    tokens.push_back(0);
  }
  const auto half = static_cast<std::ptrdiff_t>(tokens.size() / 2);
  EXPECT_TRUE(std::equal(tokens.begin(), tokens.begin() + half, tokens.begin() + half, tokens.end()));
}

}  // namespace
}  // namespace regolab::test
