/// Which model repairs, by verdict.
#include "scheduler/gap/fit.h"

#include <gtest/gtest.h>

namespace regolab::gap {
namespace {

Diagnosis diagnosis(Verdict verdict, std::vector<std::string> classes) {
  const auto model = [](const std::string& name, const std::string& cause, int effects) {
    return Weighed{.model = name, .cause = cause, .strength = std::vector<Strength>(static_cast<std::size_t>(effects)), .draws = {}};
  };
  Diagnosis d{.verdict = verdict, .classes = std::move(classes)};
  d.models = {model("unknown", "unknown", 0), model("seating", "apparatus", 1), model("cohesion+seating", "apparatus+cohesion", 2), model("cohesion", "cohesion", 1), model("none", "none", 0)};
  return d;
}

std::string repaired(Verdict verdict, std::vector<std::string> classes) {
  const Diagnosis d = diagnosis(verdict, std::move(classes));
  const Weighed* found = repaired_by(d);
  return found ? found->model : "";
}

TEST(Fit, RepairsWithTheMostProbableEffectOfTheVerdict) {
  EXPECT_EQ(repaired(Verdict::kEffect, {"cohesion"}), "cohesion") << "not the more probable one of another class";
  EXPECT_EQ(repaired(Verdict::kEffect, {"apparatus"}), "seating");
  EXPECT_EQ(repaired(Verdict::kPair, {"apparatus", "cohesion"}), "cohesion+seating");
  EXPECT_EQ(repaired(Verdict::kOneOf, {"unknown", "cohesion", "none"}), "cohesion");
}

TEST(Fit, RepairsNothingWhereNoEffectIsNamed) {
  EXPECT_EQ(repaired(Verdict::kOneOf, {"unknown", "none"}), "");
  EXPECT_EQ(repaired(Verdict::kNoGap, {"none"}), "");
  EXPECT_EQ(repaired(Verdict::kNoneOfThese, {"unknown"}), "");
  EXPECT_EQ(repaired(Verdict::kCannotTell, {}), "");
  EXPECT_EQ(base_of(diagnosis(Verdict::kNoGap, {}))->model, "none");
}

}  // namespace
}  // namespace regolab::gap
