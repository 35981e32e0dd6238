// The job reader on thousands of damaged files: it never crashes, and what it refuses it explains.
#include <gtest/gtest.h>

#include <cmath>

#include "input/job_file.h"
#include "input/yaml_tree.h"
#include "support/diagnostics.h"
#include "support/mutate.h"

namespace regolab {
namespace {

void expect_sound(const Read<Job>& read, const std::string& text) {
  ASSERT_EQ(read.value.has_value(), read.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : read.diagnostics) {
    ASSERT_FALSE(diagnostic.text.empty()) << text;
    ASSERT_GE(diagnostic.line, 0) << text;
    const std::string shown = to_text(diagnostic);
    ASSERT_FALSE(first_bad_byte(diagnostic.text)) << shown;  // messages are clean text whatever the file was
  }
  if (!read.ok()) return;
  const Micro& m = read.value->micro;
  for (const double number :
       {m.friction_angle, m.normal_stiffness, m.normal_damping, m.tangential_stiffness, m.tangential_damping, m.gravity}) {
    ASSERT_TRUE(std::isfinite(number) && number >= 0) << text;
  }
  ASSERT_GT(m.largest_diameter, 0) << text;
  ASSERT_GE(read.value->numerics.clusters, 10) << text;
  ASSERT_LE(read.value->numerics.clusters, 20000) << text;
}

TEST(JobFuzz, DamagedFilesAreRefusedWithReasonsOrReadSoundly) {
  const std::string good = testing_support::read_file(REGOLAB_SOURCE "/client/examples/job.yaml");
  ASSERT_FALSE(good.empty());
  testing_support::Dice dice(2025);
  int refused = 0;
  constexpr int kFiles = 5000;
  for (int i = 0; i < kFiles; ++i) {
    const std::string text = testing_support::mutated(good, dice);
    const Read<Job> read = read_job(text, "fuzz.yaml");
    ASSERT_NO_FATAL_FAILURE(expect_sound(read, text));
    refused += read.ok() ? 0 : 1;
  }
  EXPECT_GT(refused, kFiles / 2);  // else the mutations do not bite
  EXPECT_LT(refused, kFiles);
}

TEST(JobFuzz, EveryPrefixIsHandled) {
  const std::string good = testing_support::read_file(REGOLAB_SOURCE "/client/examples/job.yaml");
  for (std::size_t length = 0; length <= good.size(); ++length) {
    const std::string text = good.substr(0, length);
    ASSERT_NO_FATAL_FAILURE(expect_sound(read_job(text, "cut.yaml"), text));
  }
}

TEST(JobFuzz, RandomBytesAreNoFile) {
  testing_support::Dice dice(7);
  for (int i = 0; i < 500; ++i) {
    std::string text(dice.below(300), '\0');
    for (char& c : text) c = static_cast<char>(dice.below(256));
    ASSERT_NO_FATAL_FAILURE(expect_sound(read_job(text, "random.yaml"), text));
  }
}

}  // namespace
}  // namespace regolab
