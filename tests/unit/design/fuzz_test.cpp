// The design reader on damaged designs and tables: it never crashes, and what it refuses it explains.
#include <gtest/gtest.h>

#include "input/yaml_tree.h"
#include "scheduler/design/design_file.h"
#include "scheduler/design/expand.h"
#include "support/diagnostics.h"
#include "support/mutate.h"

namespace regolab {
namespace {

void expect_sound(const Read<Design>& read, const std::string& text) {
  ASSERT_EQ(read.value.has_value(), read.diagnostics.empty()) << text;
  for (const Diagnostic& diagnostic : read.diagnostics) {
    ASSERT_FALSE(diagnostic.text.empty()) << text;
    ASSERT_FALSE(first_bad_byte(diagnostic.text)) << to_text(diagnostic);
  }
  if (!read.ok()) return;
  ASSERT_FALSE(read.value->points.empty()) << text;
  for (const DesignPoint& point : read.value->points) {
    ASSERT_EQ(point.level.size(), read.value->factors.size()) << text;
    for (std::size_t i = 0; i < point.level.size(); ++i) {
      ASSERT_LT(static_cast<std::size_t>(point.level[i]), read.value->factors[i].labels.size()) << text;
    }
    ASSERT_GT(point.micro.largest_diameter, 0) << text;
    ASSERT_GT(point.micro.normal_stiffness, 0) << text;
  }
  ASSERT_FALSE(expand(*read.value).empty()) << text;
}

TEST(DesignFuzz, DamagedDesignsAreRefusedWithReasonsOrReadSoundly) {
  testing_support::Dice dice(12);
  for (const char* name : {"article-l32.yaml", "small-l4.yaml"}) {
    const std::string good = testing_support::read_file(std::string(REGOLAB_SOURCE "/client/examples/") + name);
    ASSERT_FALSE(good.empty());
    int refused = 0;
    for (int i = 0; i < 1000; ++i) {
      const std::string text = testing_support::mutated(good, dice);
      const Read<Design> read = read_design({text, name, {}}, {});
      ASSERT_NO_FATAL_FAILURE(expect_sound(read, text));
      refused += read.ok() ? 0 : 1;
    }
    EXPECT_GT(refused, 300) << name;
    EXPECT_LT(refused, 1000) << name;
  }
}

TEST(DesignFuzz, DamagedTablesToo) {
  testing_support::Dice dice(13);
  const std::string design =
      "array: {table: t.csv}\nfixed: {K_N: 1e5 N/m, eta_N: 0.25 N s/m, K_T: 7.5e4 N/m, eta_T: 1 N s/m, L_S: 1 cm, rotation: "
      "none}\n";
  const std::string csv = "point,theta_F_deg,N_E,gravity (m/s2)\n1,10,2,1.63\n2,10,6,9.8\n3,40,2,9.8\n4,40,6,1.63\n";
  ASSERT_TRUE(read_design({design, "d.yaml", {{"t.csv", csv}}}, {}).ok());
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = testing_support::mutated(csv, dice);
    const Read<Design> read = read_design({design, "d.yaml", {{"t.csv", text}}}, {});
    ASSERT_NO_FATAL_FAILURE(expect_sound(read, text));
    refused += read.ok() ? 0 : 1;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 3000);
}

}  // namespace
}  // namespace regolab
