#include "scheduler/gap/features.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scheduler/gap/curve_mean.h"
#include "unit/gap/dev_files.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Feature* find(const std::vector<Feature>& features, const std::string& id) {
  for (const Feature& f : features) {
    if (f.id == id) return &f;
  }
  return nullptr;
}

Readings without_scalar(Readings readings, const std::string& id) {
  EXPECT_EQ(readings.scalars.erase(id), 1U) << id;
  return readings;
}

TEST(Features, OfTheIndependentCodeAgreeBetweenItsNumbersAndItsCurves) {
  for (const char* name : kDevFiles) {
    const Readings readings = readings_of(dev_set(name));
    for (const double sigma3 : sigma3_of(readings)) {
      const std::string x = std::to_string(sigma3 / 1000);
      for (const auto& [scalar, feature] : {std::pair{"sigma1_at_sigma3_", "sigma1_ratio_"}, {"sigma3_measured_at_sigma3_", "sigma3_measured_ratio_"}}) {
        std::string at = std::to_string(sigma3 / 1000);
        at.erase(at.find_last_not_of('0') + 1);
        if (at.back() == '.') at.pop_back();
        const auto both = features_of(readings), curve_only = features_of(without_scalar(readings, scalar + at + "kPa"));
        const Feature *a = find(both, feature + at), *b = find(curve_only, feature + at);
        ASSERT_TRUE(a && b) << name << " " << feature << at;
        EXPECT_NEAR(a->value, b->value, 0.35 * a->standard_error + 0.004) << name << " " << feature << at;
        EXPECT_NEAR(a->standard_error, b->standard_error, 0.9 * a->standard_error + 0.002) << name << " " << feature << at;
      }
    }
  }
}

TEST(Features, PrintThem) {
  for (const char* name : kDevFiles) {
    const auto set = dev_set(name);
    std::printf("%s\n", name);
    for (const Feature& f : features_of(readings_of(set))) std::printf("  %-30s %-24s %9.4f +- %.4f\n", f.id.c_str(), f.group.text().c_str(), f.value, f.standard_error);
    for (const auto& u : set.unused) std::printf("  unused %s: %s\n", u.id.c_str(), u.why.c_str());
    for (const auto& w : set.warnings) std::printf("  %s\n", to_text(w).c_str());
  }
}

}  // namespace
}  // namespace regolab::gap
