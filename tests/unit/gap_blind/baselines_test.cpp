/// Baselines and true gaps in a made-up world of straight lines.
#include "scheduler/gap/blind/baselines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scheduler/gap/blind/true_gap.h"

namespace regolab::gap {
namespace {

double golden(int k, double step) { return std::fmod(0.5 + step * k, 1.0); }

/// Density and slope answer to friction; cohesion steepens slopes alone, a wrong grain density shows in the balance alone.
std::vector<double> measure(double friction, double cohesion, double density, int dither) {
  const auto noise = [&](int k) { return std::sin(1e4 * friction + 77.0 * dither + 13.0 * k); };
  return {4 - 2 * friction + 0.02 * noise(1), (1700 - 200 * friction) * (1 + density) + 3 * noise(2),
          0.4 + 0.3 * friction + 0.15 * std::log1p(cohesion / 600) + 0.02 * noise(3)};
}

const Emulator& emulator() {
  static const auto made = [] {
    Bank bank{.inputs = {{"theta_F", "rad"}, {"cohesion", "Pa"}, {"grain_density", "1"}},
              .features = {"contacts_per_particle", "bulk_density", "repose_angle"},
              .rows = {}};
    const auto add = [&](int point, int seed, double cohesion, double density) {
      const double friction = golden(point, 0.7549);
      bank.rows.push_back({.experiment = cohesion != 0  ? "c"
                                         : density != 0 ? "d"
                                                        : "n",
                           .point = point,
                           .seed = static_cast<std::uint64_t>(seed),
                           .profile = "quick",
                           .inputs = {friction, cohesion, density},
                           .features = measure(friction, cohesion, density, 100 * point + seed)});
    };
    for (int point = 1; point <= 60; ++point) add(point, 1, 0, 0), add(point, 2, 0, 0);
    for (int k = 1; k <= 24; ++k) add(2 * k, 1, 20 * std::pow(1000.0, golden(k, 0.618)), 0), add(2 * k + 1, 1, 0, -0.05 + 0.1 * golden(k, 0.618));
    return Emulator::from(bank);
  }();
  return *made;
}

ObservationSet measured(double friction, double cohesion, double density) {
  ObservationSet set;
  set.specimen.particles = 300;
  const char* ids[] = {"contacts_per_particle", "bulk_density", "repose_angle"};
  const char* units[] = {"1", "kg/m3", "rad"};
  for (std::size_t j = 0; j < 3; ++j) {
    double mean = 0;
    for (int seed = 0; seed < 3; ++seed) mean += measure(friction, cohesion, density, 9000 + seed)[j] / 3;
    const double error = std::sqrt(emulator().noise()[static_cast<Eigen::Index>(j)] / 3);
    set.scalars.push_back(
        {.id = ids[j], .value = mean, .unit = units[j], .unit_as_read = units[j], .standard_error = error, .seeds = 3, .definition = {}});
  }
  return set;
}

TEST(Baselines, FindAStrongEffect) {
  const Baselines found = baselines_of(emulator(), measured(0.6, 5000, 0), 1);
  EXPECT_EQ(found.lowest_rms, "cohesion");
  EXPECT_EQ(found.bic, "cohesion");
  EXPECT_EQ(found.nearest_pattern, "cohesion");
  EXPECT_LT(found.base_misfit_p, 0.01);
  double sum = 0;
  for (const Refit& r : found.refits) sum += r.bic_probability;
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(Baselines, BicAndThePatternSpareABaseModelThatFits) {
  const Baselines found = baselines_of(emulator(), measured(0.6, 0, 0), 1);
  EXPECT_EQ(found.refits.front().model, "none");
  EXPECT_EQ(found.refits.front().parameters, 2) << "friction, and how much codes differ";
  EXPECT_EQ(found.bic, "none");
  EXPECT_EQ(found.nearest_pattern, "none");
  EXPECT_GT(found.base_misfit_p, 0.05);
}

TEST(Baselines, TheSameSeedGivesTheSameBits) {
  const Baselines a = baselines_of(emulator(), measured(0.6, 300, 0), 5), b = baselines_of(emulator(), measured(0.6, 300, 0), 5);
  for (std::size_t k = 0; k < a.refits.size(); ++k) EXPECT_EQ(a.refits[k].rms, b.refits[k].rms);
}

Truth cohesive(double strength) {
  Truth t{.id = "c", .kind = TruthKind::kEffect, .effects = {{"cohesion", strength}}};
  t.material = {.friction_deg = 0.6 * 180 / 3.14159265, .largest_cm = 1, .gravity = 1.63, .elements = "6", .rotation = "x"};
  return t;
}

TEST(TrueGap, GrowsWithTheStrengthAndLiesWhereItMoves) {
  const auto weak = true_gap(emulator(), measured(0.6, 20, 0), cohesive(20)), strong = true_gap(emulator(), measured(0.6, 5000, 0), cohesive(5000));
  ASSERT_TRUE(weak && strong);
  EXPECT_LT(weak->isolability, 2);
  EXPECT_GT(strong->isolability, 4);
  EXPECT_EQ(strong->moved, "repose");
}

TEST(TrueGap, IsNotKnownOfNullsUnknownsAndWhatTheBankLacks) {
  const ObservationSet set = measured(0.6, 0, 0);
  EXPECT_FALSE(true_gap(emulator(), set, {.id = "n"}).has_value());
  EXPECT_FALSE(true_gap(emulator(), set, {.id = "u", .kind = TruthKind::kUnknown, .unknown = "batches"}).has_value());
  EXPECT_FALSE(true_gap(emulator(), set, {.id = "e", .kind = TruthKind::kEffect, .effects = {{"breakage", 3}}}).has_value());
}

TEST(TrueGap, OfAPairIsThatOfTheWeakerOne) {
  Truth pair = cohesive(5000);
  const double strong = true_gap(emulator(), measured(0.6, 5000, 0), pair)->isolability;
  pair.kind = TruthKind::kPair, pair.effects["grain_density"] = 0.001;
  EXPECT_LT(true_gap(emulator(), measured(0.6, 5000, 0.001), pair)->isolability, 0.5 * strong);
}

}  // namespace
}  // namespace regolab::gap
