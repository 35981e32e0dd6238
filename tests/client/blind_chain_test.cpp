/// A blind set from drawing to record with the programs themselves, killed on the way: real runs, a real solver, a made-up small bank.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scheduler/gap/bank.h"
#include "tests/client/programs.h"

namespace regolab {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Straight lines in friction; enough for emulators of three features.
std::string small_bank() {
  gap::Bank bank{.inputs = {{"theta_F", "rad"}, {"cohesion", "Pa"}},
                 .features = {"contacts_per_particle", "bulk_density", "repose_angle_whole"},
                 .rows = {}};
  for (int k = 0; k < 100; ++k) {
    const int point = k < 80 ? k / 2 : k;
    const double friction = std::fmod(0.5 + 0.7549 * point, 1.0), cohesion = k < 80 ? 0 : 20 * std::pow(1000.0, std::fmod(0.618 * k, 1.0));
    const auto noise = [&](int j) { return std::sin(77.0 * k + 13.0 * j); };
    bank.rows.push_back({.experiment = k < 80 ? "n" : "c",
                         .point = point,
                         .seed = static_cast<std::uint64_t>(k % 2),
                         .profile = "quick",
                         .inputs = {friction, cohesion},
                         .features = {4 - 2 * friction + 0.1 * noise(1), 1700 - 200 * friction + 20 * noise(2),
                                      0.4 + 0.3 * friction + 0.1 * std::log1p(cohesion / 600) + 0.05 * noise(3)}});
  }
  return gap::bank_csv(bank);
}

class BlindChain : public Programs {};

TEST_F(BlindChain, GoesFromDrawingToRecordOverKills) {
  write("bank.csv", small_bank());
  const std::string make = "gap blind make set --cases 0 --nulls 2 --specimens 1 --workers 2";
  shell("$regolab " + make + " 2>make.err & pid=$!; for i in $(seq 600); do grep -q '^case ' make.err && break; sleep 0.2; done; kill -KILL $pid");
  const std::string committed = read("set/commitments");
  ASSERT_THAT(committed, HasSubstr("# SHA-256 of the lines above"));
  const Ran made = regolab(make + " --json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(json::parse(made.out)["measured"], 2);
  EXPECT_EQ(read("set/commitments"), committed);

  EXPECT_EQ(regolab("gap blind reveal set").code, 2);
  const Ran one = regolab("gap blind solve set --bank bank.csv --only 1");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("1 of 2 cases answered"));
  shell("$regolab gap blind solve set --bank bank.csv 2>/dev/null & pid=$!; sleep 0.3; kill -KILL $pid");  // before the answer, or after it
  const Ran solved = regolab("gap blind solve set --bank bank.csv");
  ASSERT_EQ(solved.code, 0) << solved.err;
  EXPECT_THAT(solved.out, HasSubstr("2 of 2 cases answered"));
  EXPECT_EQ(shell("cd set/cases && sha256sum -c ../answers").code, 0);

  const Ran revealed = regolab("gap blind reveal set --bank bank.csv --json");
  ASSERT_EQ(revealed.code, 0) << revealed.err;
  const json score = json::parse(revealed.out);
  EXPECT_EQ(score["extra_nulls"], 2);
  EXPECT_EQ(score["development"], false);
  EXPECT_EQ(score["not_answered"], 0);
  EXPECT_EQ(shell("cd set/truths && sha256sum -c ../commitments").code, 0);
  EXPECT_THAT(read("set/record.csv"), HasSubstr("no new descriptors"));
}

}  // namespace
}  // namespace regolab
