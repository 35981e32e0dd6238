/// The threads of a step: every part of every round once, nothing lost, an orderly end.
#include "worker/dem/team.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

namespace regolab::dem {
namespace {

/// What one part saw; a cache line of its own. Plain numbers: a round's end must make them visible to the caller.
struct alignas(64) Seen {
  int calls = 0;
  int first_late = -1;  ///< round in which the part did not find what the caller had just written
  long sum = 0;
};

/// `rounds` of work so small that handing it out is all there is; the caller reads and writes between rounds.
void expect_each_part_once(Team& team, int rounds) {
  std::vector<Seen> seen(static_cast<std::size_t>(team.size()) + 1);
  int now = 0;  // plain: a round's start must make it visible to the team
  for (int round = 1; round <= rounds; ++round) {
    now = round;
    team.run([&, round](int t) {
      Seen& mine = seen[static_cast<std::size_t>(t)];
      ++mine.calls;
      mine.sum += now;
      if (now != round && mine.first_late < 0) mine.first_late = round;
    });
    for (int t = 0; t < team.size(); ++t) {
      ASSERT_EQ(seen[static_cast<std::size_t>(t)].calls, round) << "part " << t << " of " << team.size();
    }
  }
  for (int t = 0; t < team.size(); ++t) {
    EXPECT_EQ(seen[static_cast<std::size_t>(t)].sum, static_cast<long>(rounds) * (rounds + 1) / 2) << "part " << t;
    EXPECT_EQ(seen[static_cast<std::size_t>(t)].first_late, -1) << "part " << t;
  }
  EXPECT_EQ(seen.back().calls, 0) << "a part beyond the team's size";
}

class TeamOf : public testing::TestWithParam<int> {};

TEST_P(TeamOf, DoesEveryPartOfEveryRoundOnce) {
  Team team(GetParam());
  ASSERT_EQ(team.size(), GetParam());
  expect_each_part_once(team, 100);
}

TEST_P(TeamOf, RunsTheCallersPartOnTheCallerAndTheRestElsewhere) {
  Team team(GetParam());
  std::vector<std::thread::id> ran(static_cast<std::size_t>(GetParam()));
  team.run([&](int t) { ran[static_cast<std::size_t>(t)] = std::this_thread::get_id(); });
  for (std::size_t t = 0; t < ran.size(); ++t) {
    EXPECT_EQ(ran[t] == std::this_thread::get_id(), t == 0);
    for (std::size_t other = 0; other < t; ++other) EXPECT_NE(ran[t], ran[other]);
  }
}

/// Longer than a waiting thread spins.
void let_them_sleep() { std::this_thread::sleep_for(std::chrono::milliseconds(3)); }

TEST_P(TeamOf, GoesAwayIdleWhetherItNeverWorkedOrSpinsOrSleeps) {
  for (int i = 0; i < 20; ++i) Team never_worked(GetParam());
  for (int i = 0; i < 20; ++i) {
    Team spins(GetParam());
    expect_each_part_once(spins, 2);
  }
  Team sleeps(GetParam());
  let_them_sleep();
}

TEST_P(TeamOf, WakesUpForWorkAfterASleep) {
  Team team(GetParam());
  for (int i = 0; i < 3; ++i) {
    let_them_sleep();
    expect_each_part_once(team, 1);
  }
}

/// The caller finishes first, and must wait: asleep, too.
TEST_P(TeamOf, WaitsForTheSlowestPart) {
  Team team(GetParam());
  std::vector<int> done(static_cast<std::size_t>(GetParam()));
  team.run([&](int t) {
    if (t > 0) let_them_sleep();
    done[static_cast<std::size_t>(t)] = 1;
  });
  EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Sizes, TeamOf, testing::Range(1, 5));

/// Quiet cores spin through this in milliseconds. On busy ones every round sleeps and wakes, which is rarer and says more: there fewer
/// rounds do.
TEST(Team, LosesNothingOverTenThousandTinyRounds) {
  Team team(2);
  const auto enough = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  for (int rounds = 0; rounds < 10'000; rounds += 250) {
    expect_each_part_once(team, 250);
    if (HasFatalFailure() || std::chrono::steady_clock::now() > enough) break;
  }
}

TEST(MyTeam, IsKeptUntilAnotherSizeIsAskedForAndBelongsToItsThread) {
  Team* const mine = &my_team(2);
  EXPECT_EQ(&my_team(2), mine);
  EXPECT_EQ(my_team(3).size(), 3);
  expect_each_part_once(my_team(2), 10);
  std::jthread([&, here = &my_team(2)] {
    EXPECT_NE(&my_team(2), here);
    expect_each_part_once(my_team(2), 10);
  }).join();
}

}  // namespace
}  // namespace regolab::dem
