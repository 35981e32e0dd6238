// The observation and CSV readers on thousands of damaged files: they never crash, and what they refuse they explain.
#include <gtest/gtest.h>

#include <cmath>

#include "input/yaml_tree.h"
#include "scheduler/gap/bank.h"
#include "scheduler/gap/features.h"
#include "scheduler/gap/observation_csv.h"
#include "support/mutate.h"
#include "unit/gap/dev_files.h"

namespace regolab::gap {
namespace {

using testing_support::Dice;
using testing_support::mutated;

template <class T>
void expect_explained(const Read<T>& read, const std::string& text) {
  ASSERT_EQ(read.value.has_value(), read.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : read.diagnostics) {
    ASSERT_FALSE(diagnostic.text.empty()) << text;
    ASSERT_FALSE(first_bad_byte(diagnostic.text)) << to_text(diagnostic);
  }
}

void expect_sound(const Read<ObservationSet>& read, const std::string& text) {
  ASSERT_NO_FATAL_FAILURE(expect_explained(read, text));
  if (!read.ok()) return;
  for (const Feature& f : features_of(readings_of(*read.value))) {
    ASSERT_TRUE(std::isfinite(f.value) && std::isfinite(f.standard_error) && f.standard_error >= 0 && f.repeats >= 1) << f.id << "\n" << text;
  }
  const auto again = read_observations("again.yaml", observations_yaml(*read.value), MissingErrors::kAssume);
  ASSERT_TRUE(again.ok()) << to_text(again.diagnostics.front()) << "\n" << observations_yaml(*read.value);
}

/// The first of its curves only: mutations of long lists are all alike.
std::string short_file() {
  const std::string text = dev_text("dev-03");
  return text.substr(0, text.find("- id: sigma3_at_sigma3_1.25kPa\n  test"));
}

TEST(ObservationFuzz, DamagedFilesAreRefusedWithReasonsOrReadSoundly) {
  const std::string good = short_file();
  ASSERT_GT(good.size(), 3000U);
  ASSERT_TRUE(read_observations("good", good).ok());
  Dice dice(2026);
  int refused = 0;
  constexpr int kFiles = 1500;
  for (int i = 0; i < kFiles; ++i) {
    const std::string text = mutated(good, dice);
    const auto read = read_observations("fuzz.yaml", text, i % 2 == 0 ? MissingErrors::kAssume : MissingErrors::kRefuse);
    ASSERT_NO_FATAL_FAILURE(expect_sound(read, text));
    refused += read.ok() ? 0 : 1;
  }
  EXPECT_GT(refused, kFiles / 4);
  EXPECT_LT(refused, kFiles);
}

TEST(ObservationFuzz, TruncatedFilesAreHandled) {
  const std::string good = short_file();
  for (std::size_t length = 0; length <= good.size(); length += 7) {
    const std::string text = good.substr(0, length);
    ASSERT_NO_FATAL_FAILURE(expect_sound(read_observations("cut.yaml", text), text));
  }
}

TEST(ObservationFuzz, DamagedTablesAndMapsAreHandled) {
  const std::string map = testing_support::read_file(REGOLAB_SOURCE "/client/examples/measurements-map.yaml");
  const std::string csv = testing_support::read_file(REGOLAB_SOURCE "/client/examples/measurements.csv");
  ASSERT_TRUE(read_measurements({"m", map, "c", csv}).ok());
  Dice dice(11);
  for (int i = 0; i < 1500; ++i) {
    const bool in_map = i % 2 == 0;
    const CsvSource source{"m", in_map ? mutated(map, dice) : map, "c", in_map ? csv : mutated(csv, dice)};
    ASSERT_NO_FATAL_FAILURE(expect_sound(read_measurements(source), in_map ? source.map_text : source.csv_text));
  }
}

TEST(ObservationFuzz, DamagedBanksAreHandled) {
  const std::string good = "experiment,point,seed,profile,theta_F_rad,bulk_density_kg_per_m3,repose_angle_rad\na,1,1,quick,0.3,1600,0.7\na,1,2,quick,0.3,1610,\n";
  ASSERT_TRUE(read_bank("b", good).ok());
  Dice dice(5);
  for (int i = 0; i < 3000; ++i) {
    const std::string text = mutated(good, dice);
    ASSERT_NO_FATAL_FAILURE(expect_explained(read_bank("b", text), text));
  }
}

}  // namespace
}  // namespace regolab::gap
